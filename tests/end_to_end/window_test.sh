#!/usr/bin/env bash
# The real window on a virtual display: a simulated participant plays a short
# study by mouse, and a real pointer (xdotool) works the first pages of the demo.
set -euo pipefail

. "$(dirname "$0")/display.sh"

ask() { sqlite3 -readonly "$1" "$2"; }

# Waits until a query gives what is wanted; says what it gave last.
wait_for() {  # wait_for SECONDS DB QUERY WANTED
  local found=
  for _ in $(seq $(($1 * 5))); do
    found=$(ask "$2" "$3" 2>/dev/null || true)
    [ "$found" = "$4" ] && return
    sleep 0.2
  done
  expect "$3" "$4" "$found"
}

no_display_says_so() {
  local status=0
  env -u DISPLAY -u WAYLAND_DISPLAY "$program" run configs/demo.toml --db "$folder/none.db" \
    2>"$folder/said" || status=$?
  expect "exit code without a display" 1 "$status"
  grep -q "no display" "$folder/said"
  expect "files left without a display" "" "$(ls "$folder" | grep none || true)"
}

broken_input_opens_nothing() {
  local status=0
  "$program" run "$folder/missing.toml" --db "$folder/missing.db" 2>/dev/null || status=$?
  expect "exit code of a missing study" 2 "$status"
  status=0
  "$program" run configs/demo.toml --language xx --db "$folder/missing.db" 2>/dev/null || status=$?
  expect "exit code of an unknown language" 2 "$status"
  expect "files left by broken input" "" "$(ls "$folder" | grep missing || true)"
}

write_short_study() {
  cat >"$1" <<'END'
[study]
name = "short"
set = "builtin:A"
languages = ["en"]
seed = 1

[[interface]]
name = "labels"

[[task]]
name = "match"
kind = "match"
limit_s = 10
threshold = "auto"
dwell_ms = 500
start = "average"
targets = [{ example = "proud" }]

[[task]]
name = "find"
kind = "find"
qualities = [{ name = "tired", en = "tired" }]

[[rating]]
item = "satisfaction"
question = { en = "How satisfied are you?" }
low = { en = "not at all" }
high = { en = "completely" }
points = 7
END
}

# says_why SAID LINES: the short study with these lines of [display] cannot run.
says_why() {
  local status=0
  write_short_study "$folder/display.toml"
  printf '[display]\n%s\n' "$2" >>"$folder/display.toml"
  "$program" run "$folder/display.toml" --autopilot 1 --db "$folder/display.db" \
    2>"$folder/said" || status=$?
  expect "exit code with $2" 1 "$status"
  grep -q "$1" "$folder/said" || { cat "$folder/said" >&2; exit 1; }
  expect "files left with $2" "" "$(ls "$folder" | grep display.db || true)"
}

displays_that_are_not_there_are_named() {
  says_why "display 7 is not there; the displays are 1 (screen, 1280 x 720)" "screen = 7"
  says_why 'there is only 1 (screen, 1280 x 720); .* set examples = "panel"' 'examples = "screen"'
}

autopilot_plays_a_short_study() {
  local db=$folder/auto.db
  write_short_study "$folder/short.toml"
  timeout 200 "$program" run "$folder/short.toml" --autopilot 1 --windowed --db "$db"
  expect "sessions" "finished|1" "$(ask "$db" "SELECT outcome, simulated FROM session")"
  expect "trials without an outcome" 0 \
    "$(ask "$db" "SELECT count(*) FROM trial WHERE outcome IS NULL")"
  expect "trials that count" 2 "$(ask "$db" "SELECT count(*) FROM trial WHERE practice = 0")"
  expect "trials without presses" 0 "$(ask "$db" "SELECT count(*) FROM trial WHERE NOT EXISTS
    (SELECT 1 FROM event WHERE trial = trial.uuid AND kind = 'press' AND actor = 'participant')")"
  expect "changes that are no events" 0 "$(ask "$db" "SELECT count(*) FROM trial WHERE changes <>
    (SELECT count(*) FROM event WHERE trial = trial.uuid AND actor = 'participant'
     AND kind IN ('pick', 'slide', 'only'))")"
  expect "trials without samples" 0 "$(ask "$db" "SELECT count(*) FROM trial WHERE NOT EXISTS
    (SELECT 1 FROM sample WHERE trial = trial.uuid)")"
}

click() { xdotool mousemove "$1" "$2" sleep 0.2 click 1 sleep 0.3; }

a_real_mouse_works_the_first_pages() {
  local db=$folder/mouse.db
  "$program" run configs/demo.toml --windowed --pilot --station lab --db "$db" &
  running=$!
  xdotool search --sync --onlyvisible --name demo >/dev/null
  sleep 3  # it looks at the machine first
  click 640 280  # English
  click 460 385  # the field for the code
  xdotool type --delay 60 P07
  click 860 664  # Start
  wait_for 20 "$db" "SELECT code FROM participant" P07
  click 860 664  # I agree
  wait_for 20 "$db" "SELECT count(*) FROM event WHERE kind = 'page' AND target = 'instructions'" 1
  expect "language" "en" "$(ask "$db" "SELECT language FROM session")"
  expect "what the doctor said of this machine" 7 \
    "$(ask "$db" "SELECT json_array_length(machine, '$.doctor.checks') FROM session")"
  expect "presses" 4 "$(ask "$db" "SELECT count(*) FROM event WHERE kind = 'press'
    AND actor = 'participant' AND uncertainty_us >= 0 AND x > 0")"
  local status=0
  kill -TERM "$running"
  wait "$running" || status=$?
  running=
  expect "exit code of an interrupted session" 1 "$status"
  expect "who stopped it" "experimenter" "$(ask "$db" "SELECT actor FROM event WHERE kind = 'stop'")"
  expect "session" "stopped|0|1|lab" \
    "$(ask "$db" "SELECT outcome, simulated, pilot, station FROM session")"
}

cd "${PROMENADE_SOURCE_DIR:-$(dirname "$0")/../..}"
no_display_says_so
broken_input_opens_nothing
displays_that_are_not_there_are_named
a_real_mouse_works_the_first_pages
autopilot_plays_a_short_study
echo "the window works"
