# The convergence of a spectrum. First: celt lyapunov --iterates 400000 --output csv > FILE, then
#   gnuplot -e "history='FILE'" docs/convergence.gp > docs/convergence.svg
set terminal svg size 900,330 font 'sans,12' background rgb 'white'
set datafile separator ','
set grid lc rgb '#e0e0e0'
set xlabel 'iterates'
set format x '%.0s%c'
set format y '%.4f'
set xrange [0:*]
set xtics 200000
unset key
records = sprintf("< grep ^record %s", history)
set multiplot layout 1,3 title 'Lyapunov exponents of the Celtic stone per iterate at E = 752'
do for [i=1:3] {
  set title sprintf('Λ_%d', i)
  set autoscale y
  stats records using (column(3 + i)) nooutput
  middle = (STATS_max + STATS_min)/2
  set yrange [middle - 0.0012 : middle + 0.0012]
  plot records using (strlen(strcol(6 + i)) > 0 ? column(3) : NaN): \
           (column(3 + i) - column(6 + i)):(column(3 + i) + column(6 + i)) \
           with filledcurves lc rgb '#c9dcea', \
       '' using 3:(column(3 + i)) with linespoints lc rgb '#1b6ca8' pt 7 ps 0.35
}
unset multiplot
