# d_over_time-2-match
# gnuplot d_over_time-2-match.gp writes d_over_time-2-match.svg and d_over_time-2-match.pdf again.
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
set bmargin at screen 0.1621
set tmargin at screen 0.8914
set xtics nomirror scale 0.5 offset 0,0.3
set label 'Time since the trial began (s)' at screen 0.5647,0.0324 center
set label 'D (cm)' at screen 0.0294,0.5267 center rotate by 90
set arrow from screen 0.0353,0.9357 to screen 0.0824,0.9357 nohead dt 1 lw 2 lc rgb '#0072b2'
set label 'map' at screen 0.0941,0.9357 left
set arrow from screen 0.2047,0.9357 to screen 0.2517,0.9357 nohead dt (10,4) lw 2 lc rgb '#e69f00'
set label 'labels' at screen 0.2635,0.9357 left
set xrange [0:45]
set yrange [0:14.190871376789996]
set terminal svg size 241,175 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'd_over_time-2-match.svg'
plot 'd_over_time-2-match.csv' using ($2==0 ? $1 : 1/0):($3*100):($5*100) with filledcurves fs transparent solid 0.13 noborder lc rgb '#0072b2', \
  'd_over_time-2-match.csv' using ($2==1 ? $1 : 1/0):($3*100):($5*100) with filledcurves fs transparent solid 0.13 noborder lc rgb '#e69f00', \
  'd_over_time-2-match.csv' using ($2==0 ? $1 : 1/0):($4*100) with lines dt 1 lw 2 lc rgb '#0072b2', \
  'd_over_time-2-match.csv' using ($2==1 ? $1 : 1/0):($4*100) with lines dt (10,4) lw 2 lc rgb '#e69f00'
set terminal pdfcairo size 8.500cm,6.170cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'd_over_time-2-match.pdf'
replot
set output
