#!/usr/bin/env bash
# A path is drawn in the real window with a real mouse (xdotool) on a virtual display; the figure
# walks it, and the walk is saved as a capture. Closing the window ends a search that is not done.
set -euo pipefail

. "$(dirname "$0")/display.sh"
cd "$folder"

open_window() {  # open_window ARGUMENTS...
  "$program" graph path walks.graph --window "$@" &
  running=$!
  xdotool search --sync --onlyvisible --name "a path" >/dev/null
  sleep 1  # the first frames
}

close_window() {
  local status=0
  kill -TERM "$running"
  wait "$running" || status=$?
  running=
  expect "exit code of a window that is closed" 0 "$status"
}

# The ground is seen 10 m wide on 400 pixels, its middle at (1056, 272).
draw_four_metres_ahead() {
  xdotool mousemove 1056 352 sleep 0.2 mousedown 1 sleep 0.1
  for y in 340 320 300 280 260 240 220 200; do xdotool mousemove 1056 $y sleep 0.05; done
  xdotool mousemove 1056 192 sleep 0.2 mouseup 1 sleep 0.2
}

press_save_until_there_is_a_walk() {
  for _ in $(seq 60); do
    xdotool mousemove 1184 672 sleep 0.1 click 1 sleep 0.3
    [ ! -s walk.bvh ] || return 0
  done
  echo "nothing was saved" >&2
  exit 1
}

the_walk_is_four_metres_long() {
  "$program" motion info walk.bvh --json >info.json
  python3 - <<'END_OF_CHECK'
import json
info = json.load(open("info.json"))[0]
assert abs(info["travel_m"] - 4) < 0.3, info["travel_m"]
assert 1 < info["seconds"] < 10, info["seconds"]
END_OF_CHECK
}

a_window_closes_in_the_middle_of_a_search() {
  printf 'x,z\n' >long.csv
  for k in $(seq 0 40); do printf '%d,%d\n' $((k % 2 * 8)) "$k" >>long.csv; done
  open_window --path long.csv --horizon 20 --most-edges 1000000000
  close_window
}

"$program" graph build builtin:A --out walks.graph >/dev/null 2>&1
open_window --out walk.bvh
draw_four_metres_ahead
press_save_until_there_is_a_walk
close_window
the_walk_is_four_metres_long
a_window_closes_in_the_middle_of_a_search
echo "a path was drawn, walked and saved"
