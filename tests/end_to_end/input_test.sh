#!/usr/bin/env bash
# Two thousand events of a real pointer and keyboard on a virtual display: none is lost,
# their order is kept, and every press is in the database. How well they are stamped
# depends on the machine: tools/measure-input, results/reliability.md.
set -euo pipefail

program=${MEASURE_INPUT:?names the program that injects them}
status=$(mktemp)
trap 'rm -f "$status"' EXIT

# xvfb-run's own exit code may tell of its tidying up.
timeout 300 xvfb-run -a -s "-screen 0 1280x720x24" \
  sh -c "\"$program\" 2000 200; echo \$? >\"$status\"" || true
[ "$(cat "$status")" = 0 ]
