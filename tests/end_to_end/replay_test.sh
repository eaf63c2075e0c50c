#!/usr/bin/env bash
# Plays trials again from the database alone: as pictures, and in the real window.
set -euo pipefail

. "$(dirname "$0")/display.sh"

# fails SAID CODE ARGUMENTS...: replay ends with that code and says so.
fails() {
  local said=$1 wanted=$2 status=0
  shift 2
  "$program" replay "$@" >"$folder/out" 2>"$folder/said" || status=$?
  expect "exit code of replay $*" "$wanted" "$status"
  grep -q "$said" "$folder/said" || { cat "$folder/said" >&2; exit 1; }
}

what_is_wrong_is_said_and_nothing_is_written() {
  fails "has no trial x" 2 "$db" --trial x --frames "$folder/none"
  fails "WIDTHxHEIGHT" 2 "$db" --frames "$folder/none" --size 100x100
  fails "is not empty" 2 "$db" --frames "$folder"
  fails "goes with" 2 "$db" --json
  (unset DISPLAY WAYLAND_DISPLAY; fails "no display" 1 "$db" --frames "$folder/none")
  expect "files left" "" "$(ls "$folder" | grep none || true)"
}

pictures_are_the_same_each_time_and_change_with_the_trial() {
  local options=(--fps 2 --size 640x376)
  "$program" replay "$db" --trial "$trial" --frames "$folder/one" "${options[@]}" --json \
    >"$folder/said.json"
  "$program" replay "$db" --trial "$trial" --frames "$folder/two" "${options[@]}" >/dev/null
  diff -r "$folder/one" "$folder/two"
  local count
  count=$(python3 -c 'import json, sys; print(json.load(sys.stdin)["pictures"])' \
    <"$folder/said.json")
  expect "pictures" "$count" "$(ls "$folder/one" | wc -l)"
  expect "different pictures" "$count" "$(sha256sum "$folder/one"/* | cut -c 1-64 | sort -u | wc -l)"
  expect "size" "640x376" "$(identify -format %wx%h "$folder/one/frame-00001.png")"
}

an_interrupt_leaves_whole_pictures() {
  local status=0
  "$program" replay "$db" --trial "$trial" --frames "$folder/stopped" --fps 500 >/dev/null \
    2>"$folder/said" &
  running=$!
  until [ -e "$folder/stopped/frame-00003.png" ]; do sleep 0.1; done
  kill -INT "$running"
  wait "$running" || status=$?
  running=
  expect "exit code of an interrupted replay" 1 "$status"
  grep -q "stopped after" "$folder/said"
  identify "$folder/stopped"/* >/dev/null
  expect "other files" "" "$(ls "$folder/stopped" | grep -v '^frame-[0-9]*\.png$' || true)"
}

a_window_plays_it_and_esc_closes_it() {
  "$program" replay "$db" --windowed --speed 20 &
  running=$!
  xdotool search --sync --onlyvisible --name "Promenade: replay" >/dev/null
  sleep 1
  xdotool key space sleep 0.2 key Left sleep 0.2 key Escape
  wait "$running"
  running=
}

cd "${PROMENADE_SOURCE_DIR:-$(dirname "$0")/../..}"
db=$folder/demo.db
"$program" simulate configs/demo.toml --participants 1 --seed 3 --db "$db" 2>/dev/null >&2
before=$(sha256sum "$db")
trial=$("$program" replay "$db" --list --json | python3 -c '
import json, sys
print(min(json.load(sys.stdin)["trials"], key=lambda trial: trial["seconds"])["uuid"])')
what_is_wrong_is_said_and_nothing_is_written
pictures_are_the_same_each_time_and_change_with_the_trial
an_interrupt_leaves_whole_pictures
a_window_plays_it_and_esc_closes_it
expect "database" "$before" "$(sha256sum "$db")"
echo "trials play again"
