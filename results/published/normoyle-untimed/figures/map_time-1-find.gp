# map_time-1-find
# gnuplot map_time-1-find.gp writes map_time-1-find.svg and map_time-1-find.pdf again.
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
set yrange [0:100.42619197435187]
unset border
unset grid
unset xtics
unset ytics
colour(share) = share >= 0.1 ? 0x0078bd : share >= 0.05 ? 0x4595cf : share >= 0.02 ? 0x77b0dc : share >= 0.01 ? 0xa5c8e4 : share >= 0.005 ? 0xcad8e4 : 0xe3e5e7
left(panel) = 3.000 + 88.000 * (int(panel) % 2)
below(panel) = 100.426 - 91.426 * (int(panel) / 2 + 1)
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
set object rectangle from 3.000,9.000 to 87.000,91.926 front fs empty border lc rgb '#777777' lw 0.8
set label 'map' at 3.000,96.926 left
set label '85 trials, 15.8 min, 6.8 % beyond the edge' at 3.000,93.626 left tc rgb '#444444' font 'Noto Sans,6'
set label 'sneaking' at 59.212,57.566 left front font 'Noto Sans,6'
set label 'prowling' at 59.815,43.415 left front font 'Noto Sans,6'
set label 'stalking' at 75.690,43.485 left front font 'Noto Sans,6'
set label 'creeping' at 54.052,51.169 left front font 'Noto Sans,6'
set label 'skulking' at 67.144,34.187 left front font 'Noto Sans,6'
set label 'hobbling' at 67.833,41.214 left front font 'Noto Sans,6'
set label 'exhausted' at 60.043,24.789 left front font 'Noto Sans,6'
set label 'burdened' at 74.018,72.398 left front font 'Noto Sans,6'
set label 'against-the-wind' at 65.392,51.909 left front font 'Noto Sans,6'
set label 'cowering' at 70.263,64.456 left front font 'Noto Sans,6'
set label 'ducking' at 78.887,61.940 left front font 'Noto Sans,6'
set label 'searching' at 57.245,31.959 left front font 'Noto Sans,6'
set label 'freezing' at 65.633,67.235 left front font 'Noto Sans,6'
set label 'hunchbacked' at 67.325,28.050 left front font 'Noto Sans,6'
set label 'witch' at 76.867,68.266 left front font 'Noto Sans,6'
set label 'miner' at 60.123,28.391 left front font 'Noto Sans,6'
set label 'on-ice' at 54.824,39.907 left front font 'Noto Sans,6'
set label 'old' at 60.506,35.535 left front font 'Noto Sans,6'
set label 'normal' at 18.283,25.426 left front font 'Noto Sans,6'
set label 'proud' at 16.219,31.705 left front font 'Noto Sans,6'
set label 'marching' at 8.223,20.059 left front font 'Noto Sans,6'
set label 'catwalk' at 24.765,19.804 left front font 'Noto Sans,6'
set label 'brisk' at 33.788,33.464 left front font 'Noto Sans,6'
set label 'tiptoeing' at 28.993,26.872 left front font 'Noto Sans,6'
set label 'strolling' at 7.080,24.294 left front font 'Noto Sans,6'
set label 'elegant' at 24.386,30.728 left front font 'Noto Sans,6'
set label 'shy' at 25.018,33.867 left front font 'Noto Sans,6'
set label 'sad' at 32.938,22.539 left front font 'Noto Sans,6'
set label 'drunk' at 10.825,28.350 left front font 'Noto Sans,6'
set label 'hands-in-pockets' at 26.494,37.349 left front font 'Noto Sans,6'
set label 'sleepwalking' at 42.007,15.911 left front font 'Noto Sans,6'
set label 'robot' at 29.215,41.957 left front font 'Noto Sans,6'
set label 'cowboy' at 10.850,55.841 left front font 'Noto Sans,6'
set label 'bodybuilder' at 5.539,70.012 left front font 'Noto Sans,6'
set label 'sumo' at 21.100,67.548 left front font 'Noto Sans,6'
set label 'gorilla' at 34.779,57.356 left front font 'Noto Sans,6'
set label 'giant' at 10.086,64.575 left front font 'Noto Sans,6'
set label 'macho' at 18.107,73.866 left front font 'Noto Sans,6'
set label 'toddler' at 39.427,83.704 left front font 'Noto Sans,6'
set label 'sailor' at 19.648,64.176 left front font 'Noto Sans,6'
set label 'wrestler' at 36.327,70.360 left front font 'Noto Sans,6'
set label 'bouncer' at 25.142,74.897 left front font 'Noto Sans,6'
set label 'monster' at 31.274,66.690 left front font 'Noto Sans,6'
set label 'knight' at 15.028,80.507 left front font 'Noto Sans,6'
set label 'bully' at 24.747,70.979 left front font 'Noto Sans,6'
set label 'strutting' at 19.871,85.016 left front font 'Noto Sans,6'
set label 'rider' at 26.951,79.740 left front font 'Noto Sans,6'
set object rectangle from 91.000,9.000 to 175.000,91.926 front fs empty border lc rgb '#777777' lw 0.8
set label 'labels' at 91.000,96.926 left
set label '85 trials, 15.9 min' at 91.000,93.626 left tc rgb '#444444' font 'Noto Sans,6'
set label 'sneaking' at 147.212,57.566 left front font 'Noto Sans,6'
set label 'prowling' at 147.815,43.415 left front font 'Noto Sans,6'
set label 'stalking' at 163.690,43.485 left front font 'Noto Sans,6'
set label 'creeping' at 142.052,51.169 left front font 'Noto Sans,6'
set label 'skulking' at 155.144,34.187 left front font 'Noto Sans,6'
set label 'hobbling' at 155.833,41.214 left front font 'Noto Sans,6'
set label 'exhausted' at 148.043,24.789 left front font 'Noto Sans,6'
set label 'burdened' at 162.018,72.398 left front font 'Noto Sans,6'
set label 'against-the-wind' at 153.392,51.909 left front font 'Noto Sans,6'
set label 'cowering' at 158.263,64.456 left front font 'Noto Sans,6'
set label 'ducking' at 166.887,61.940 left front font 'Noto Sans,6'
set label 'searching' at 145.245,31.959 left front font 'Noto Sans,6'
set label 'freezing' at 153.633,67.235 left front font 'Noto Sans,6'
set label 'hunchbacked' at 155.325,28.050 left front font 'Noto Sans,6'
set label 'witch' at 164.867,68.266 left front font 'Noto Sans,6'
set label 'miner' at 148.123,28.391 left front font 'Noto Sans,6'
set label 'on-ice' at 142.824,39.907 left front font 'Noto Sans,6'
set label 'old' at 148.506,35.535 left front font 'Noto Sans,6'
set label 'normal' at 106.283,25.426 left front font 'Noto Sans,6'
set label 'proud' at 104.219,31.705 left front font 'Noto Sans,6'
set label 'marching' at 96.223,20.059 left front font 'Noto Sans,6'
set label 'catwalk' at 112.765,19.804 left front font 'Noto Sans,6'
set label 'brisk' at 121.788,33.464 left front font 'Noto Sans,6'
set label 'tiptoeing' at 116.993,26.872 left front font 'Noto Sans,6'
set label 'strolling' at 95.080,24.294 left front font 'Noto Sans,6'
set label 'elegant' at 112.386,30.728 left front font 'Noto Sans,6'
set label 'shy' at 113.018,33.867 left front font 'Noto Sans,6'
set label 'sad' at 120.938,22.539 left front font 'Noto Sans,6'
set label 'drunk' at 98.825,28.350 left front font 'Noto Sans,6'
set label 'hands-in-pockets' at 114.494,37.349 left front font 'Noto Sans,6'
set label 'sleepwalking' at 130.007,15.911 left front font 'Noto Sans,6'
set label 'robot' at 117.215,41.957 left front font 'Noto Sans,6'
set label 'cowboy' at 98.850,55.841 left front font 'Noto Sans,6'
set label 'bodybuilder' at 93.539,70.012 left front font 'Noto Sans,6'
set label 'sumo' at 109.100,67.548 left front font 'Noto Sans,6'
set label 'gorilla' at 122.779,57.356 left front font 'Noto Sans,6'
set label 'giant' at 98.086,64.575 left front font 'Noto Sans,6'
set label 'macho' at 106.107,73.866 left front font 'Noto Sans,6'
set label 'toddler' at 127.427,83.704 left front font 'Noto Sans,6'
set label 'sailor' at 107.648,64.176 left front font 'Noto Sans,6'
set label 'wrestler' at 124.327,70.360 left front font 'Noto Sans,6'
set label 'bouncer' at 113.142,74.897 left front font 'Noto Sans,6'
set label 'monster' at 119.274,66.690 left front font 'Noto Sans,6'
set label 'knight' at 103.028,80.507 left front font 'Noto Sans,6'
set label 'bully' at 112.747,70.979 left front font 'Noto Sans,6'
set label 'strutting' at 107.871,85.016 left front font 'Noto Sans,6'
set label 'rider' at 114.951,79.740 left front font 'Noto Sans,6'
set terminal svg size 505,285 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'map_time-1-find.svg'
plot 'map_time-1-find.csv' using (left($1)+($2+0.5)*8.4000):(below($1)+($3+0.5)*8.2926):(4.1000):(4.0463):(colour($4)) with boxxyerror fs solid noborder lc rgb variable, \
  for [panel=0:1] 'map_time-1-find-examples.csv' using (left(panel)+$1*8.4000):(below(panel)+$2*8.2926) with points pt 7 ps 0.2 lc rgb '#000000'
set terminal pdfcairo size 17.800cm,10.043cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'map_time-1-find.pdf'
replot
set output
