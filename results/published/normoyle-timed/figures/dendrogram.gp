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
set lmargin at screen 0.3475
set rmargin at screen 0.9647
set bmargin at screen 0.0515
set tmargin at screen 0.9871
set xtics nomirror scale 0.5 offset 0,0.3
set label 'Distance at which motions merge' at screen 0.6561,0.0103 center
set xrange [0:67.14934978272531]
set xtics 20
set yrange [0.5:55.5]
set ytics ('stalking' 55, 'hobbling' 54, 'hunchbacked' 53, 'miner' 52, 'prowling' 51, 'on-ice' 50, 'skulking' 49, 'searching' 48, 'exhausted' 47, 'old' 46, 'ducking' 45, 'burdened' 44, 'witch' 43, 'sneaking' 42, 'creeping' 41, 'against-the-wind' 40, 'cowering' 39, 'freezing' 38, 'proud' 37, 'marching' 36, 'catwalk' 35, 'penguin' 34, 'strolling' 33, 'swaggering' 32, 'drunk' 31, 'carrying-a-bag' 30, 'tiptoeing' 29, 'elegant' 28, 'hands-in-pockets' 27, 'robot' 26, 'sleepwalking' 25, 'shy' 24, 'brisk' 23, 'bouncing' 22, 'normal' 21, 'dreaming' 20, 'sad' 19, 'limping' 18, 'toddler' 17, 'gorilla' 16, 'sumo' 15, 'wrestler' 14, 'monster' 13, 'bodybuilder' 12, 'cowboy' 11, 'gunslinger' 10, 'weightlifter' 9, 'giant' 8, 'sailor' 7, 'bully' 6, 'macho' 5, 'strutting' 4, 'bouncer' 3, 'knight' 2, 'rider' 1) scale 0
set grid xtics noytics lc rgb '#dddddd' lw 0.6 dt 1
set border 1
set terminal svg size 241,550 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'dendrogram.svg'
plot 'dendrogram.csv' using 1:2 with lines lw 1.2 lc rgb '#0072b2'
set terminal pdfcairo size 8.500cm,19.400cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'dendrogram.pdf'
replot
set output
