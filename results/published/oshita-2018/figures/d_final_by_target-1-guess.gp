# d_final_by_target-1-guess
# gnuplot d_final_by_target-1-guess.gp writes d_final_by_target-1-guess.svg and d_final_by_target-1-guess.pdf again.
reset
set encoding utf8
set datafile separator comma columnheaders commentschars ''
set minussign
set key off
set border 3 lw 0.8 lc rgb '#444444'
set tics out scale 0.5
set ytics nomirror
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set lmargin at screen 0.0787
set rmargin at screen 0.9831
set bmargin at screen 0.1040
set tmargin at screen 0.8839
set xrange [0.5:6.5]
set xtics ('target1' 1, 'target2' 2, 'target3' 3, 'target4' 4, 'target5' 5, 'all' 6) scale 0 nomirror
set label 'Final D (cm)' at screen 0.0140,0.4939 center rotate by 90
set label '' at screen 0.0281,0.9312 point pt 7 ps 0.5 lw 1.2 lc rgb '#0072b2' front
set label 'weights' at screen 0.0449,0.9312 left
set label '' at screen 0.1412,0.9312 point pt 5 ps 0.5 lw 1.2 lc rgb '#e69f00' front
set label 'adjectives' at screen 0.1580,0.9312 left
set label '' at screen 0.2763,0.9312 point pt 9 ps 0.5 lw 1.2 lc rgb '#009e73' front
set label 'features' at screen 0.2931,0.9312 left
set yrange [0:9.01166857051099]
set arrow from 5.5, graph 0 to 5.5, graph 1 nohead lw 0.6 lc rgb '#999999'
set arrow from graph 0, first 2.7923788585001708 to graph 1, first 2.7923788585001708 nohead dt (6,4) lw 1 lc rgb '#444444'
set terminal svg size 505,164 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'd_final_by_target-1-guess.svg'
plot 'd_final_by_target-1-guess.csv' using ($1+-0.160):($2==0 ? $3*100 : 1/0):($4*100):($5*100) with yerrorbars pt 0 lw 1.2 lc rgb '#0072b2', \
  'd_final_by_target-1-guess.csv' using ($1+-0.160):($2==0 ? $3*100 : 1/0) with points pt 7 ps 0.5 lw 1.2 lc rgb '#0072b2', \
  'd_final_by_target-1-guess.csv' using ($1+0.000):($2==1 ? $3*100 : 1/0):($4*100):($5*100) with yerrorbars pt 0 lw 1.2 lc rgb '#e69f00', \
  'd_final_by_target-1-guess.csv' using ($1+0.000):($2==1 ? $3*100 : 1/0) with points pt 5 ps 0.5 lw 1.2 lc rgb '#e69f00', \
  'd_final_by_target-1-guess.csv' using ($1+0.160):($2==2 ? $3*100 : 1/0):($4*100):($5*100) with yerrorbars pt 0 lw 1.2 lc rgb '#009e73', \
  'd_final_by_target-1-guess.csv' using ($1+0.160):($2==2 ? $3*100 : 1/0) with points pt 9 ps 0.5 lw 1.2 lc rgb '#009e73'
set terminal pdfcairo size 17.800cm,5.770cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'd_final_by_target-1-guess.pdf'
replot
set output
