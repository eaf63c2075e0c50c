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
set lmargin at screen 0.4073
set rmargin at screen 0.9647
set bmargin at screen 0.0984
set tmargin at screen 0.9754
set xtics nomirror scale 0.5 offset 0,0.3
set label 'Distance at which motions merge' at screen 0.6860,0.0197 center
set xrange [0:44.31623829979066]
set xtics 10
set yrange [0.5:27.5]
set ytics ('misery-slow' 27, 'misery-fast' 26, 'misery-normal' 25, 'distress-slow' 24, 'distress-fast' 23, 'distress-normal' 22, 'depression-fast' 21, 'depression-normal' 20, 'depression-slow' 19, 'sleepiness-fast' 18, 'sleepiness-normal' 17, 'sleepiness-slow' 16, 'arousal-fast' 15, 'arousal-normal' 14, 'excitement-fast' 13, 'excitement-normal' 12, 'pleasure-slow' 11, 'neutral-slow' 10, 'neutral-fast' 9, 'neutral-normal' 8, 'pleasure-fast' 7, 'pleasure-normal' 6, 'excitement-slow' 5, 'arousal-slow' 4, 'contentment-slow' 3, 'contentment-fast' 2, 'contentment-normal' 1) scale 0
set grid xtics noytics lc rgb '#dddddd' lw 0.6 dt 1
set border 1
set terminal svg size 241,288 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'dendrogram.svg'
plot 'dendrogram.csv' using 1:2 with lines lw 1.2 lc rgb '#0072b2'
set terminal pdfcairo size 8.500cm,10.160cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'dendrogram.pdf'
replot
set output
