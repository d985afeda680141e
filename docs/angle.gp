# Where the attractor can be pseudo-hyperbolic. First:
#   celt sweep --axis energy=749:755:61 hyperbolicity --output csv > FILE, then
#   gnuplot -e "sweep='FILE'" docs/angle.gp > docs/angle.svg
set terminal svg size 900,420 font 'sans,12' background rgb 'white'
set datafile separator ','
set grid lc rgb '#e0e0e0'
set key outside top center horizontal
set xlabel 'energy'
set ylabel 'least angle of E^{ss} and E^{cu} [rad]'
set logscale y
set format y '10^{%T}'
set xrange [748.95:755.05]
of(name, angle) = strcol('verdict') eq name ? angle : NaN
plot sweep using 'value_1':(column('minimum_angle')) with lines lc rgb '#d0d0d0' notitle, \
     '' using 'value_1':(of('TANGENCIES', column('minimum_angle'))) with points pt 7 ps 0.7 lc rgb '#b8552c' title 'tangencies', \
     '' using 'value_1':(of('UNDECIDED', column('minimum_angle'))) with points pt 6 ps 0.7 lc rgb '#404040' title 'undecided', \
     '' using 'value_1':(of('PSEUDO_HYPERBOLIC', column('minimum_angle'))) with points pt 7 ps 0.7 lc rgb '#2a8a3e' title 'pseudo-hyperbolic'
