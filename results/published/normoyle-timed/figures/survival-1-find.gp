# survival-1-find
# gnuplot survival-1-find.gp writes survival-1-find.svg and survival-1-find.pdf again.
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
set bmargin at screen 0.2859
set tmargin at screen 0.9075
set xtics nomirror scale 0.5 offset 0,0.3
set label 'Time (s)' at screen 0.5647,0.1754 center
set label 'Not yet done (%)' at screen 0.0294,0.5967 center rotate by 90
set arrow from screen 0.0353,0.9452 to screen 0.0824,0.9452 nohead dt 1 lw 2 lc rgb '#0072b2'
set label 'map' at screen 0.0941,0.9452 left
set arrow from screen 0.2047,0.9452 to screen 0.2517,0.9452 nohead dt (10,4) lw 2 lc rgb '#e69f00'
set label 'labels' at screen 0.2635,0.9452 left
set xrange [0:38.908791]
set xtics 10
set yrange [0:104]
set label 'Still at it' at screen 0.0176,0.1312 left
set label 'map' at screen 0.0176,0.0843 left
set label '85' at screen 0.1647,0.0843 center
set label '39' at screen 0.3703,0.0843 center
set label '5' at screen 0.5759,0.0843 center
set label '2' at screen 0.7815,0.0843 center
set label 'labels' at screen 0.0176,0.0373 left
set label '85' at screen 0.1647,0.0373 center
set label '38' at screen 0.3703,0.0373 center
set label '7' at screen 0.5759,0.0373 center
set label '2' at screen 0.7815,0.0373 center
set terminal svg size 241,205 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'survival-1-find.svg'
plot 'survival-1-find.csv' using ($2==0 ? $1 : 1/0):($3*100) with steps dt 1 lw 2 lc rgb '#0072b2', \
  'survival-1-find.csv' using ($2==1 ? $1 : 1/0):($3*100) with steps dt (10,4) lw 2 lc rgb '#e69f00', \
  'survival-1-find.csv' using ($2==0 && $6>0 ? $1 : 1/0):($3*100) with points pt 1 ps 0.5 lw 2 lc rgb '#0072b2', \
  'survival-1-find.csv' using ($2==1 && $6>0 ? $1 : 1/0):($3*100) with points pt 1 ps 0.5 lw 2 lc rgb '#e69f00'
set terminal pdfcairo size 8.500cm,7.240cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'survival-1-find.pdf'
replot
set output
