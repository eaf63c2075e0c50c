# survival
# gnuplot survival.gp writes survival.svg and survival.pdf again.
reset
set encoding utf8
set datafile separator comma columnheaders commentschars ''
set minussign
set key off
set border 3 lw 0.8 lc rgb '#444444'
set tics out scale 0.5
set ytics nomirror
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set lmargin at screen 0.2418
set rmargin at screen 0.9647
set bmargin at screen 0.2859
set tmargin at screen 0.9075
set xtics nomirror scale 0.5 offset 0,0.3
set label 'Time (s)' at screen 0.6032,0.1754 center
set label 'Not yet done (%)' at screen 0.0294,0.5967 center rotate by 90
set arrow from screen 0.0353,0.9452 to screen 0.0824,0.9452 nohead dt 1 lw 2 lc rgb '#0072b2'
set label 'adjectives' at screen 0.0941,0.9452 left
set arrow from screen 0.3182,0.9452 to screen 0.3653,0.9452 nohead dt (10,4) lw 2 lc rgb '#e69f00'
set label 'weights' at screen 0.3771,0.9452 left
set xrange [0:300]
set xtics 50
set yrange [0:104]
set label 'Still at it' at screen 0.0176,0.1312 left
set label 'adjectives' at screen 0.0176,0.0843 left
set label '60' at screen 0.2418,0.0843 center
set label '13' at screen 0.3623,0.0843 center
set label '4' at screen 0.4827,0.0843 center
set label '2' at screen 0.6032,0.0843 center
set label '1' at screen 0.7237,0.0843 center
set label '0' at screen 0.8442,0.0843 center
set label '0' at screen 0.9647,0.0843 center
set label 'weights' at screen 0.0176,0.0373 left
set label '60' at screen 0.2418,0.0373 center
set label '33' at screen 0.3623,0.0373 center
set label '16' at screen 0.4827,0.0373 center
set label '10' at screen 0.6032,0.0373 center
set label '4' at screen 0.7237,0.0373 center
set label '3' at screen 0.8442,0.0373 center
set label '3' at screen 0.9647,0.0373 center
set terminal svg size 241,205 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'survival.svg'
plot 'survival.csv' using ($2==0 ? $1 : 1/0):($3*100) with steps dt 1 lw 2 lc rgb '#0072b2', \
  'survival.csv' using ($2==1 ? $1 : 1/0):($3*100) with steps dt (10,4) lw 2 lc rgb '#e69f00', \
  'survival.csv' using ($2==0 && $6>0 ? $1 : 1/0):($3*100) with points pt 1 ps 0.5 lw 2 lc rgb '#0072b2', \
  'survival.csv' using ($2==1 && $6>0 ? $1 : 1/0):($3*100) with points pt 1 ps 0.5 lw 2 lc rgb '#e69f00'
set terminal pdfcairo size 8.500cm,7.240cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'survival.pdf'
replot
set output
