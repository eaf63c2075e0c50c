# survival-2-match
# gnuplot survival-2-match.gp writes survival-2-match.svg and survival-2-match.pdf again.
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
set bmargin at screen 0.3179
set tmargin at screen 0.9116
set xtics nomirror scale 0.5 offset 0,0.3
set label 'Time (s)' at screen 0.6032,0.2124 center
set label 'Not yet done (%)' at screen 0.0294,0.6148 center rotate by 90
set arrow from screen 0.0353,0.9476 to screen 0.0824,0.9476 nohead dt 1 lw 2 lc rgb '#0072b2'
set label 'weights' at screen 0.0941,0.9476 left
set arrow from screen 0.2721,0.9476 to screen 0.3191,0.9476 nohead dt (10,4) lw 2 lc rgb '#e69f00'
set label 'adjectives' at screen 0.3309,0.9476 left
set arrow from screen 0.5550,0.9476 to screen 0.6021,0.9476 nohead dt (3,3) lw 2 lc rgb '#009e73'
set label 'features' at screen 0.6139,0.9476 left
set xrange [0:300]
set xtics 50
set yrange [0:104]
set label 'Still at it' at screen 0.0176,0.1702 left
set label 'weights' at screen 0.0176,0.1253 left
set label '65' at screen 0.2418,0.1253 center
set label '32' at screen 0.3623,0.1253 center
set label '16' at screen 0.4827,0.1253 center
set label '8' at screen 0.6032,0.1253 center
set label '8' at screen 0.7237,0.1253 center
set label '7' at screen 0.8442,0.1253 center
set label '7' at screen 0.9647,0.1253 center
set label 'adjectives' at screen 0.0176,0.0805 left
set label '65' at screen 0.2418,0.0805 center
set label '2' at screen 0.3623,0.0805 center
set label '1' at screen 0.4827,0.0805 center
set label '1' at screen 0.6032,0.0805 center
set label '0' at screen 0.7237,0.0805 center
set label '0' at screen 0.8442,0.0805 center
set label '0' at screen 0.9647,0.0805 center
set label 'features' at screen 0.0176,0.0356 left
set label '65' at screen 0.2418,0.0356 center
set label '14' at screen 0.3623,0.0356 center
set label '7' at screen 0.4827,0.0356 center
set label '5' at screen 0.6032,0.0356 center
set label '4' at screen 0.7237,0.0356 center
set label '4' at screen 0.8442,0.0356 center
set label '3' at screen 0.9647,0.0356 center
set terminal svg size 241,215 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'survival-2-match.svg'
plot 'survival-2-match.csv' using ($2==0 ? $1 : 1/0):($3*100) with steps dt 1 lw 2 lc rgb '#0072b2', \
  'survival-2-match.csv' using ($2==1 ? $1 : 1/0):($3*100) with steps dt (10,4) lw 2 lc rgb '#e69f00', \
  'survival-2-match.csv' using ($2==2 ? $1 : 1/0):($3*100) with steps dt (3,3) lw 2 lc rgb '#009e73', \
  'survival-2-match.csv' using ($2==0 && $6>0 ? $1 : 1/0):($3*100) with points pt 1 ps 0.5 lw 2 lc rgb '#0072b2', \
  'survival-2-match.csv' using ($2==1 && $6>0 ? $1 : 1/0):($3*100) with points pt 1 ps 0.5 lw 2 lc rgb '#e69f00', \
  'survival-2-match.csv' using ($2==2 && $6>0 ? $1 : 1/0):($3*100) with points pt 1 ps 0.5 lw 2 lc rgb '#009e73'
set terminal pdfcairo size 8.500cm,7.580cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'survival-2-match.pdf'
replot
set output
