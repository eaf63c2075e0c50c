# failures
# gnuplot failures.gp writes failures.svg and failures.pdf again.
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
set bmargin at screen 0.2381
set tmargin at screen 0.9013
set xrange [0.5:6.5]
set xtics ('adjectives1' 1, 'adjectives2' 2, 'adjectives3' 3, 'adjectives4' 4, 'adjectives5' 5, 'all' 6) scale 0 rotate by 45 right nomirror
set label 'Failed (%)' at screen 0.0294,0.5697 center rotate by 90
set label '' at screen 0.0588,0.9415 point pt 7 ps 0.5 lw 1.2 lc rgb '#0072b2' front
set label 'adjectives' at screen 0.0941,0.9415 left
set label '' at screen 0.3418,0.9415 point pt 5 ps 0.5 lw 1.2 lc rgb '#e69f00' front
set label 'weights' at screen 0.3771,0.9415 left
set yrange [0:105]
set arrow from 5.5, graph 0 to 5.5, graph 1 nohead lw 0.6 lc rgb '#999999'
set terminal svg size 241,192 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'failures.svg'
plot 'failures.csv' using ($1+-0.080):($2==0 ? $3*100 : 1/0):($4*100):($5*100) with yerrorbars pt 0 lw 1.2 lc rgb '#0072b2', \
  'failures.csv' using ($1+-0.080):($2==0 ? $3*100 : 1/0) with points pt 7 ps 0.5 lw 1.2 lc rgb '#0072b2', \
  'failures.csv' using ($1+0.080):($2==1 ? $3*100 : 1/0):($4*100):($5*100) with yerrorbars pt 0 lw 1.2 lc rgb '#e69f00', \
  'failures.csv' using ($1+0.080):($2==1 ? $3*100 : 1/0) with points pt 5 ps 0.5 lw 1.2 lc rgb '#e69f00'
set terminal pdfcairo size 8.500cm,6.785cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'failures.pdf'
replot
set output
