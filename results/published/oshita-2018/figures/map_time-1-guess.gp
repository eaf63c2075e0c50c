# map_time-1-guess
# gnuplot map_time-1-guess.gp writes map_time-1-guess.svg and map_time-1-guess.pdf again.
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
set yrange [0:55.048247552213944]
unset border
unset grid
unset xtics
unset ytics
colour(share) = share >= 0.1 ? 0x0078bd : share >= 0.05 ? 0x4595cf : share >= 0.02 ? 0x77b0dc : share >= 0.01 ? 0xa5c8e4 : share >= 0.005 ? 0xcad8e4 : 0xe3e5e7
left(panel) = 3.000 + 58.667 * (int(panel) % 3)
below(panel) = 55.048 - 46.048 * (int(panel) / 3 + 1)
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
set object rectangle from 3.000,9.000 to 57.667,46.548 front fs empty border lc rgb '#777777' lw 0.8
set label 'weights' at 3.000,51.548 left
set label '65 trials, 22.9 min' at 3.000,48.248 left tc rgb '#444444' font 'Noto Sans,6'
set label 'excitement-fast' at 36.813,12.468 left front font 'Noto Sans,6'
set label 'excitement-normal' at 31.517,15.976 left front font 'Noto Sans,6'
set label 'excitement-slow' at 26.644,18.248 left front font 'Noto Sans,6'
set label 'pleasure-fast' at 3.578,15.650 left front font 'Noto Sans,6'
set label 'pleasure-normal' at 15.378,20.592 left front font 'Noto Sans,6'
set label 'pleasure-slow' at 10.587,22.789 left front font 'Noto Sans,6'
set label 'sleepiness-fast' at 18.093,32.578 left front font 'Noto Sans,6'
set label 'sleepiness-normal' at 13.816,35.175 left front font 'Noto Sans,6'
set label 'sleepiness-slow' at 8.406,30.282 left front font 'Noto Sans,6'
set label 'depression-fast' at 17.322,43.419 left front font 'Noto Sans,6'
set label 'depression-normal' at 13.039,40.617 left front font 'Noto Sans,6'
set label 'misery-fast' at 43.368,35.543 left front font 'Noto Sans,6'
set label 'distress-fast' at 36.915,28.510 left front font 'Noto Sans,6'
set label 'arousal-fast' at 24.938,10.221 left front font 'Noto Sans,6'
set label 'arousal-slow' at 6.027,12.496 left front font 'Noto Sans,6'
set label 'neutral-fast' at 23.420,26.271 left front font 'Noto Sans,6'
set label 'neutral-slow' at 4.698,27.259 left front font 'Noto Sans,6'
set object rectangle from 61.667,9.000 to 116.333,46.548 front fs empty border lc rgb '#777777' lw 0.8
set label 'adjectives' at 61.667,51.548 left
set label '65 trials, 21.3 min' at 61.667,48.248 left tc rgb '#444444' font 'Noto Sans,6'
set label 'excitement-fast' at 95.479,12.468 left front font 'Noto Sans,6'
set label 'excitement-normal' at 90.183,15.976 left front font 'Noto Sans,6'
set label 'excitement-slow' at 85.311,18.248 left front font 'Noto Sans,6'
set label 'pleasure-fast' at 62.245,15.650 left front font 'Noto Sans,6'
set label 'pleasure-normal' at 74.044,20.592 left front font 'Noto Sans,6'
set label 'pleasure-slow' at 69.254,22.789 left front font 'Noto Sans,6'
set label 'sleepiness-fast' at 76.759,32.578 left front font 'Noto Sans,6'
set label 'sleepiness-normal' at 72.483,35.175 left front font 'Noto Sans,6'
set label 'sleepiness-slow' at 67.072,30.282 left front font 'Noto Sans,6'
set label 'depression-fast' at 75.989,43.419 left front font 'Noto Sans,6'
set label 'depression-normal' at 71.705,40.617 left front font 'Noto Sans,6'
set label 'misery-fast' at 102.034,35.543 left front font 'Noto Sans,6'
set label 'distress-fast' at 95.582,28.510 left front font 'Noto Sans,6'
set label 'arousal-fast' at 83.605,10.221 left front font 'Noto Sans,6'
set label 'arousal-slow' at 64.693,12.496 left front font 'Noto Sans,6'
set label 'neutral-fast' at 82.086,26.271 left front font 'Noto Sans,6'
set label 'neutral-slow' at 63.364,27.259 left front font 'Noto Sans,6'
set object rectangle from 120.333,9.000 to 175.000,46.548 front fs empty border lc rgb '#777777' lw 0.8
set label 'features' at 120.333,51.548 left
set label '65 trials, 21.0 min' at 120.333,48.248 left tc rgb '#444444' font 'Noto Sans,6'
set label 'excitement-fast' at 154.146,12.468 left front font 'Noto Sans,6'
set label 'excitement-normal' at 148.850,15.976 left front font 'Noto Sans,6'
set label 'excitement-slow' at 143.978,18.248 left front font 'Noto Sans,6'
set label 'pleasure-fast' at 120.912,15.650 left front font 'Noto Sans,6'
set label 'pleasure-normal' at 132.711,20.592 left front font 'Noto Sans,6'
set label 'pleasure-slow' at 127.921,22.789 left front font 'Noto Sans,6'
set label 'sleepiness-fast' at 135.426,32.578 left front font 'Noto Sans,6'
set label 'sleepiness-normal' at 131.149,35.175 left front font 'Noto Sans,6'
set label 'sleepiness-slow' at 125.739,30.282 left front font 'Noto Sans,6'
set label 'depression-fast' at 134.656,43.419 left front font 'Noto Sans,6'
set label 'depression-normal' at 130.372,40.617 left front font 'Noto Sans,6'
set label 'misery-fast' at 160.701,35.543 left front font 'Noto Sans,6'
set label 'distress-fast' at 154.249,28.510 left front font 'Noto Sans,6'
set label 'arousal-fast' at 142.271,10.221 left front font 'Noto Sans,6'
set label 'arousal-slow' at 123.360,12.496 left front font 'Noto Sans,6'
set label 'neutral-fast' at 140.753,26.271 left front font 'Noto Sans,6'
set label 'neutral-slow' at 122.031,27.259 left front font 'Noto Sans,6'
set terminal svg size 505,156 font 'Noto Sans,8' noenhanced linewidth 0.5 background '#ffffff'
set output 'map_time-1-guess.svg'
plot 'map_time-1-guess.csv' using (left($1)+($2+0.5)*5.4667):(below($1)+($3+0.5)*3.7548):(2.6333):(1.7774):(colour($4)) with boxxyerror fs solid noborder lc rgb variable, \
  for [panel=0:2] 'map_time-1-guess-examples.csv' using (left(panel)+$1*5.4667):(below(panel)+$2*3.7548) with points pt 7 ps 0.2 lc rgb '#000000'
set terminal pdfcairo size 17.800cm,5.505cm font 'Noto Sans,8' fontscale 0.75 noenhanced linewidth 1.4
set output 'map_time-1-guess.pdf'
replot
set output
