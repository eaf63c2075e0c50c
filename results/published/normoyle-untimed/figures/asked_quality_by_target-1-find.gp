# asked_quality_by_target-1-find
# gnuplot asked_quality_by_target-1-find.gp writes asked_quality_by_target-1-find.svg and asked_quality_by_target-1-find.pdf again.
reset
set encoding utf8
set datafile separator comma columnheaders commentschars ''
set minussign
set key off
set border 3 lw 0.8 lc rgb '#444444'
set tics out scale 0.5
set ytics nomirror
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set lmargin at screen 0.1647
set rmargin at screen 0.9647
set bmargin at screen 0.2056
set tmargin at screen 0.8970
set xrange [0.5:6.5]
set xtics ('happy' 1, 'tired' 2, 'angry' 3, 'nervous' 4, 'powerful' 5, 'all' 6) scale 0 rotate by 45 right nomirror
set label 'Asked quality (simulated raters)' at screen 0.0294,0.5513 center rotate by 90
set label '' at screen 0.0588,0.9390 point pt 7 ps 0.5 lw 1.2 lc rgb '#0072b2' front
set label 'map' at screen 0.0941,0.9390 left
set label '' at screen 0.2282,0.9390 point pt 5 ps 0.5 lw 1.2 lc rgb '#e69f00' front
set label 'labels' at screen 0.2635,0.9390 left
set yrange [0:1.996209731651248]
set arrow from 5.5, graph 0 to 5.5, graph 1 nohead lw 0.6 lc rgb '#999999'
set terminal svg size 241,184 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'asked_quality_by_target-1-find.svg'
plot 'asked_quality_by_target-1-find.csv' using ($1+-0.080):($2==0 ? $3*1 : 1/0):($4*1):($5*1) with yerrorbars pt 0 lw 1.2 lc rgb '#0072b2', \
  'asked_quality_by_target-1-find.csv' using ($1+-0.080):($2==0 ? $3*1 : 1/0) with points pt 7 ps 0.5 lw 1.2 lc rgb '#0072b2', \
  'asked_quality_by_target-1-find.csv' using ($1+0.080):($2==1 ? $3*1 : 1/0):($4*1):($5*1) with yerrorbars pt 0 lw 1.2 lc rgb '#e69f00', \
  'asked_quality_by_target-1-find.csv' using ($1+0.080):($2==1 ? $3*1 : 1/0) with points pt 5 ps 0.5 lw 1.2 lc rgb '#e69f00'
set terminal pdfcairo size 8.500cm,6.508cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'asked_quality_by_target-1-find.pdf'
replot
set output
