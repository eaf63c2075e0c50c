# dendrogram
# gnuplot dendrogram.gp writes dendrogram.svg and dendrogram.pdf again.
reset
set encoding utf8
set datafile separator comma columnheaders commentschars ''
set minussign
set key off
set border 3 lw 0.8 lc rgb '#444444'
set tics out scale 0.5
set ytics nomirror
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set lmargin at screen 0.1839
set rmargin at screen 0.9647
set bmargin at screen 0.2198
set tmargin at screen 0.9451
set xtics nomirror scale 0.5 offset 0,0.3
set label 'Distance at which motions merge' at screen 0.5743,0.0440 center
set xrange [0:27.77548081996116]
set xtics 5
set yrange [0.5:10.5]
set ytics ('catwalk' 10, 'proud' 9, 'happy' 8, 'normal' 7, 'drunk' 6, 'sad' 5, 'old' 4, 'sneaky' 3, 'angry' 2, 'robot' 1) scale 0
set grid xtics noytics lc rgb '#dddddd' lw 0.6 dt 1
set border 1
set terminal svg size 241,129 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'dendrogram.svg'
plot 'dendrogram.csv' using 1:2 with lines lw 1.2 lc rgb '#0072b2'
set terminal pdfcairo size 8.500cm,4.550cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'dendrogram.pdf'
replot
set output
