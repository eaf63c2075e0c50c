#!/usr/bin/env bash
# The first closed circle, on a virtual display: somebody rates walks in the window, by mouse; the
# ratings become a model; its sliders are used in the window by somebody else; the report appears.
set -euo pipefail

program=${PROMENADE:?names the program to test}
[ -n "${DISPLAY_IS_OURS:-}" ] || exec env DISPLAY_IS_OURS=1 \
  xvfb-run -a -s "-screen 0 1280x720x24" "$0" "$@"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

expect() {  # expect SAID WANTED FOUND
  [ "$2" = "$3" ] || { echo "$1: wanted \"$2\", found \"$3\"" >&2; exit 1; }
}
ask() { sqlite3 -readonly "$1" "$2"; }
in_json() {  # in_json FILE EXPRESSION, of it
  python3 -c "import json, sys; it = json.load(open(sys.argv[1])); print($2)" "$1"
}

# Six of the 41 pairs, two walks for each person.
write_questionnaire() {
  cat >pairs.toml <<'END'
name = "pairs"
title = { en = "How does it look?" }
least = -2
most = 2
END
  for pair in slow-fast sad-happy calm-excited small-large; do
    printf '[[item]]\nname = "%s"\nlow = { en = "%s" }\nhigh = { en = "%s" }\nkind = "scale"\n' \
      "$pair" "${pair%-*}" "${pair#*-}" >>pairs.toml
  done
  cat >rate.toml <<'END'
[study]
name = "rate"
set = "builtin:A"
participants = 40
[[task]]
name = "rate"
kind = "rate"
instrument = "pairs.toml"
reference = "normal"
targets = [{ all = true }]
each = 2
END
}

somebody_rates_in_the_window() {
  timeout 300 "$program" run rate.toml --autopilot 3 --windowed --db ratings.db
  expect "sessions" "finished|1" "$(ask ratings.db "SELECT outcome, simulated FROM session")"
  expect "walks that were rated" 2 \
    "$(ask ratings.db "SELECT count(*) FROM trial WHERE outcome = 'done'")"
  expect "answers" 8 "$(ask ratings.db "SELECT count(*) FROM answer WHERE touched = 1")"
  expect "answers without a press of the mouse" 0 "$(ask ratings.db "SELECT count(*) FROM trial
    WHERE (SELECT count(*) FROM event WHERE trial = trial.uuid AND kind = 'press') < 4")"
}

ratings_become_a_model() {
  "$program" simulate rate.toml --participants 39 --seed 1 --db ratings.db
  "$program" model adjectives ratings.db --include-simulated --clusters 3 >model.json
  "$program" model adjectives ratings.db --include-simulated --clusters 3 --out model.toml
  expect "raters" 40 "$(in_json model.json "it['raters']")"
  expect "they agree" True "$(in_json model.json "it['agrees']")"
  expect "the model says who judged" 1 "$(grep -c '^simulated = true' model.toml)"
}

somebody_uses_its_sliders() {
  cat >study.toml <<'END'
[study]
name = "sliders"
set = "builtin:A"
ratings = "model.toml"
[[interface]]
name = "adjectives"
[[task]]
name = "match"
kind = "match"
limit_s = 15
threshold = "auto"
targets = [{ random = "adjectives", count = 1 }]
END
  "$program" check study.toml >check.txt 2>&1
  timeout 300 "$program" run study.toml --autopilot 4 --windowed --db study.db
  expect "sliders that were moved" 1 "$(ask study.db "SELECT count(*) > 0 FROM event
    WHERE trial IS NOT NULL AND actor = 'participant' AND kind = 'slide'")"
}

the_report_appears() {
  "$program" simulate study.toml --participants 11 --seed 2 --db study.db
  "$program" report study.db --include-simulated --out report 2>/dev/null
  "$program" report ratings.db --include-simulated --out ratings 2>/dev/null
  expect "people of the study" 12 "$(in_json report/report.json "max(one['n'] for one in it['summaries'])")"
  expect "raters of the report" 1 "$(grep -c 'id="data-quality"' ratings/report.html)"
  "$program" replay study.db --audit >/dev/null
}

write_questionnaire
somebody_rates_in_the_window
ratings_become_a_model
somebody_uses_its_sliders
the_report_appears
echo "from questionnaire to sliders to report"
