# The stone's reverse. First:
#   celt orbit --state 0,0,-14,0.01,0.01,0.9999 --time 40 --step 0.02 --output csv > FILE, then
#   gnuplot -e "orbit='FILE'" docs/reversal.gp > docs/reversal.svg
set terminal svg size 900,420 font 'sans,12' background rgb 'white'
set datafile separator ','
set grid lc rgb '#e0e0e0'
set xrange [0:40]
unset key
set lmargin 8
set multiplot layout 2,1 title 'Spun at -2 about the vertical: the stone wobbles, stops, and turns the other way'
set format x ''
set bmargin 0.5
set ylabel 'spin rate'
set ytics 1
set yrange [-2.6:2.6]
plot 0 lc rgb '#909090', orbit using 'time':'spin_rate' with lines lc rgb '#1b6ca8'
set format x '%g'
set bmargin 3
set tmargin 0.5
set xlabel 'time'
set ylabel 'tilt [rad]'
set ytics 0.1
set yrange [0:*]
plot orbit using 'time':(acos(column('gamma_3'))) with lines lc rgb '#b8552c'
unset multiplot
