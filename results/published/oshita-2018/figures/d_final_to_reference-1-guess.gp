# d_final_to_reference-1-guess
# gnuplot d_final_to_reference-1-guess.gp writes d_final_to_reference-1-guess.svg and d_final_to_reference-1-guess.pdf again.
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
set bmargin at screen 0.1897
set tmargin at screen 0.8950
set xrange [0.5:6.5]
set xtics ('target1' 1, 'target2' 2, 'target3' 3, 'target4' 4, 'target5' 5, 'all' 6) scale 0 rotate by 45 right nomirror
set label 'Difference (cm)' at screen 0.0294,0.5423 center rotate by 90
set label '' at screen 0.0588,0.9378 point pt 5 ps 0.5 lw 1.2 lc rgb '#e69f00' front
set label 'adjectives' at screen 0.0941,0.9378 left
set label '' at screen 0.3418,0.9378 point pt 9 ps 0.5 lw 1.2 lc rgb '#009e73' front
set label 'features' at screen 0.3771,0.9378 left
set yrange [-3.0278213989692153:1.9777992380963614]
set arrow from 5.5, graph 0 to 5.5, graph 1 nohead lw 0.6 lc rgb '#999999'
set arrow from graph 0, first 0 to graph 1, first 0 nohead dt (6,4) lw 1 lc rgb '#444444'
set terminal svg size 241,181 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'd_final_to_reference-1-guess.svg'
plot 'd_final_to_reference-1-guess.csv' using ($1+-0.080):($2==1 ? $3*100 : 1/0):($4*100):($5*100) with yerrorbars pt 0 lw 1.2 lc rgb '#e69f00', \
  'd_final_to_reference-1-guess.csv' using ($1+-0.080):($2==1 ? $3*100 : 1/0) with points pt 5 ps 0.5 lw 1.2 lc rgb '#e69f00', \
  'd_final_to_reference-1-guess.csv' using ($1+0.080):($2==2 ? $3*100 : 1/0):($4*100):($5*100) with yerrorbars pt 0 lw 1.2 lc rgb '#009e73', \
  'd_final_to_reference-1-guess.csv' using ($1+0.080):($2==2 ? $3*100 : 1/0) with points pt 9 ps 0.5 lw 1.2 lc rgb '#009e73'
set terminal pdfcairo size 8.500cm,6.380cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'd_final_to_reference-1-guess.pdf'
replot
set output
