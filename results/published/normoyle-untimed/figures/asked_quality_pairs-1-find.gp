# asked_quality_pairs-1-find
# gnuplot asked_quality_pairs-1-find.gp writes asked_quality_pairs-1-find.svg and asked_quality_pairs-1-find.pdf again.
reset
set encoding utf8
set datafile separator comma columnheaders commentschars ''
set minussign
set key off
set border 3 lw 0.8 lc rgb '#444444'
set tics out scale 0.5
set ytics nomirror
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set lmargin at screen 0.2586
set rmargin at screen 0.9647
set bmargin at screen 0.4444
set tmargin at screen 0.8889
set xtics nomirror scale 0.5 offset 0,0.3
set label 'Difference' at screen 0.6116,0.0889 center
set xrange [-0.3719856557448299:0.10713769312349845]
set xtics 0.1
set yrange [0.4:1.6]
set ytics ('map − labels' 1) scale 0
set grid xtics noytics lc rgb '#dddddd' lw 0.6 dt 1
set arrow from 0, graph 0 to 0, graph 1 nohead dt (6,4) lw 1 lc rgb '#444444'
set terminal svg size 241,64 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'asked_quality_pairs-1-find.svg'
plot 'asked_quality_pairs-1-find.csv' using ($2*1):1:($3*1):($4*1) with xerrorbars pt 0 lw 1.5 lc rgb '#000000', \
  'asked_quality_pairs-1-find.csv' using ($6==1 ? $2*1 : 1/0):1 with points pt 5 ps 0.6 lc rgb '#0072b2', \
  'asked_quality_pairs-1-find.csv' using ($6==1 ? 1/0 : $2*1):1 with points pt 4 ps 0.6 lw 1.2 lc rgb '#555555'
set terminal pdfcairo size 8.500cm,2.250cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'asked_quality_pairs-1-find.pdf'
replot
set output
