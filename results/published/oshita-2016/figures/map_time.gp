# map_time
# gnuplot map_time.gp writes map_time.svg and map_time.pdf again.
reset
set encoding utf8
set datafile separator comma columnheaders commentschars ''
set minussign
set key off
set border 3 lw 0.8 lc rgb '#444444'
set tics out scale 0.5
set ytics nomirror
set grid ytics lc rgb '#dddddd' lw 0.6 dt 1
set lmargin at screen 0
set rmargin at screen 1
set bmargin at screen 0
set tmargin at screen 1
set xrange [0:178]
set yrange [0:87.88419338924543]
unset border
unset grid
unset xtics
unset ytics
colour(share) = share >= 0.1 ? 0x0078bd : share >= 0.05 ? 0x4595cf : share >= 0.02 ? 0x77b0dc : share >= 0.01 ? 0xa5c8e4 : share >= 0.005 ? 0xcad8e4 : 0xe3e5e7
left(panel) = 3.000 + 88.000 * (int(panel) % 2)
below(panel) = 87.884 - 78.884 * (int(panel) / 2 + 1)
set label '% of the time, per cell:' at 3.000,4.000 left font 'Noto Sans,6'
set object rectangle from 29.680,3.800 to 37.680,5.800 fs solid noborder fc rgb '#e3e5e7'
set object rectangle from 37.680,3.800 to 45.680,5.800 fs solid noborder fc rgb '#cad8e4'
set label '0.5' at 37.680,1.800 center font 'Noto Sans,6'
set object rectangle from 45.680,3.800 to 53.680,5.800 fs solid noborder fc rgb '#a5c8e4'
set label '1' at 45.680,1.800 center font 'Noto Sans,6'
set object rectangle from 53.680,3.800 to 61.680,5.800 fs solid noborder fc rgb '#77b0dc'
set label '2' at 53.680,1.800 center font 'Noto Sans,6'
set object rectangle from 61.680,3.800 to 69.680,5.800 fs solid noborder fc rgb '#4595cf'
set label '5' at 61.680,1.800 center font 'Noto Sans,6'
set object rectangle from 69.680,3.800 to 77.680,5.800 fs solid noborder fc rgb '#0078bd'
set label '10' at 69.680,1.800 center font 'Noto Sans,6'
set object rectangle from 3.000,9.000 to 87.000,79.384 front fs empty border lc rgb '#777777' lw 0.8
set label 'adjectives' at 3.000,84.384 left
set label '60 trials, 33.8 min' at 3.000,81.084 left tc rgb '#444444' font 'Noto Sans,6'
set label 'normal' at 24.653,51.581 left front font 'Noto Sans,6'
set label 'happy' at 33.799,35.715 left front font 'Noto Sans,6'
set label 'sad' at 35.069,73.519 left front font 'Noto Sans,6'
set label 'proud' at 10.850,34.449 left front font 'Noto Sans,6'
set label 'sneaky' at 71.784,35.471 left front font 'Noto Sans,6'
set label 'angry' at 60.083,26.994 left front font 'Noto Sans,6'
set label 'catwalk' at 13.692,14.865 left front font 'Noto Sans,6'
set label 'old' at 55.348,54.617 left front font 'Noto Sans,6'
set label 'robot' at 47.718,27.746 left front font 'Noto Sans,6'
set label 'drunk' at 24.690,46.187 left front font 'Noto Sans,6'
set object rectangle from 91.000,9.000 to 175.000,79.384 front fs empty border lc rgb '#777777' lw 0.8
set label 'weights' at 91.000,84.384 left
set label '60 trials, 80.8 min' at 91.000,81.084 left tc rgb '#444444' font 'Noto Sans,6'
set label 'normal' at 112.653,51.581 left front font 'Noto Sans,6'
set label 'happy' at 121.799,35.715 left front font 'Noto Sans,6'
set label 'sad' at 123.069,73.519 left front font 'Noto Sans,6'
set label 'proud' at 98.850,34.449 left front font 'Noto Sans,6'
set label 'sneaky' at 159.784,35.471 left front font 'Noto Sans,6'
set label 'angry' at 148.083,26.994 left front font 'Noto Sans,6'
set label 'catwalk' at 101.692,14.865 left front font 'Noto Sans,6'
set label 'old' at 143.348,54.617 left front font 'Noto Sans,6'
set label 'robot' at 135.718,27.746 left front font 'Noto Sans,6'
set label 'drunk' at 112.690,46.187 left front font 'Noto Sans,6'
set terminal svg size 505,249 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'map_time.svg'
plot 'map_time.csv' using (left($1)+($2+0.5)*8.4000):(below($1)+($3+0.5)*7.0384):(4.1000):(3.4192):(colour($4)) with boxxyerror fs solid noborder lc rgb variable, \
  for [panel=0:1] 'map_time-examples.csv' using (left(panel)+$1*8.4000):(below(panel)+$2*7.0384) with points pt 7 ps 0.2 lc rgb '#000000'
set terminal pdfcairo size 17.800cm,8.788cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'map_time.pdf'
replot
set output
