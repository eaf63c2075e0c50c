# asked_quality-1-find
# gnuplot asked_quality-1-find.gp writes asked_quality-1-find.svg and asked_quality-1-find.pdf again.
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
set bmargin at screen 0.1121
set tmargin at screen 0.9533
set xrange [0.5:2.5]
set xtics ('map' 1, 'labels' 2) scale 0 nomirror
set label 'Asked quality (simulated raters)' at screen 0.0294,0.5327 center rotate by 90
set yrange [0:1.4266224180025295]
set terminal svg size 241,152 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'asked_quality-1-find.svg'
plot 'asked_quality-1-find.csv' using 1:($2*1) with lines lc rgb '#bbbbbb' lw 0.8, \
  'asked_quality-1-find.csv' using 1:($2*1) with points pt 7 ps 0.4 lc rgb '#0072b2', \
  'asked_quality-1-find-medians.csv' using ($1+0.22):($2*1):($3*1):($4*1) with yerrorbars pt 0 lw 2 lc rgb '#000000', \
  'asked_quality-1-find-medians.csv' using ($1+0.22):($2*1) with points pt 5 ps 0.6 lc rgb '#000000'
set terminal pdfcairo size 8.500cm,5.350cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'asked_quality-1-find.pdf'
replot
set output
