# dendrogram_pairs
# gnuplot dendrogram_pairs.gp writes dendrogram_pairs.svg and dendrogram_pairs.pdf again.
reset
set encoding utf8
set datafile separator comma columnheaders commentschars ''
set minussign
set key off
set border 3 lw 0.8 lc rgb '#444444'
set tics out scale 0.5
set ytics nomirror
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set lmargin at screen 0.3937
set rmargin at screen 0.9647
set bmargin at screen 0.0770
set tmargin at screen 0.9160
set xtics nomirror scale 0.5 offset 0,0.3
set label 'Distance at which pairs merge' at screen 0.6792,0.0154 center
set arrow from screen 0.0353,0.9694 to screen 0.0824,0.9694 nohead dt 1 lw 2 lc rgb '#0072b2'
set label 'quickness' at screen 0.0941,0.9694 left
set arrow from screen 0.2990,0.9694 to screen 0.3460,0.9694 nohead dt (10,4) lw 2 lc rgb '#e69f00'
set label 'clearness' at screen 0.3578,0.9694 left
set arrow from screen 0.5627,0.9694 to screen 0.6097,0.9694 nohead dt (3,3) lw 2 lc rgb '#009e73'
set label 'activeness' at screen 0.6215,0.9694 left
set arrow from screen 0.0353,0.9371 to screen 0.0824,0.9371 nohead dt (10,3,2,3) lw 2 lc rgb '#d55e00'
set label 'largeness' at screen 0.0941,0.9371 left
set xrange [0:2.1807027935852217]
set xtics 0.5
set yrange [0.5:33.5]
set ytics ('gloomy-cheerful' 33, 'tight-free' 32, 'narrow-broad' 31, 'narrow-wide' 30, 'small-large' 29, 'closed-open' 28, 'old-young' 27, 'bumpy-smooth' 26, 'ugly-cute' 25, 'unstable-stable' 24, 'vague-distinct' 23, 'ugly-beautiful' 22, 'drab-clear' 21, 'uncool-cool' 20, 'weak-strong' 19, 'dirty-clean' 18, 'unpleasant-pleasant' 17, 'heavy-light' 16, 'lonely-bustling' 15, 'sad-happy' 14, 'dark-bright' 13, 'poor-rich' 12, 'mild-violent' 11, 'quiet-noisy' 10, 'adult-childish' 9, 'dormant-brisk' 8, 'calm-excited' 7, 'simple-gaudy' 6, 'dim-sharp' 5, 'artificial-natural' 4, 'blunt-sharp' 3, 'slow-fast' 2, 'dull-quick' 1) scale 0
set grid xtics noytics lc rgb '#dddddd' lw 0.6 dt 1
set border 1
set arrow from first 1.0993608870938796,graph 0 to first 1.0993608870938796,graph 1 nohead dt (3,3) lw 0.8 lc rgb '#444444'
set terminal svg size 241,368 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'dendrogram_pairs.svg'
plot 'dendrogram_pairs.csv' using 1:($5==0?$2:NaN) with lines lw 1.2 lc rgb '#777777', 'dendrogram_pairs.csv' using 1:($5==1?$2:NaN) with lines dt 1 lw 2 lc rgb '#0072b2', 'dendrogram_pairs.csv' using 1:($5==2?$2:NaN) with lines dt (10,4) lw 2 lc rgb '#e69f00', 'dendrogram_pairs.csv' using 1:($5==3?$2:NaN) with lines dt (3,3) lw 2 lc rgb '#009e73', 'dendrogram_pairs.csv' using 1:($5==4?$2:NaN) with lines dt (10,3,2,3) lw 2 lc rgb '#d55e00'
set terminal pdfcairo size 8.500cm,12.980cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'dendrogram_pairs.pdf'
replot
set output
