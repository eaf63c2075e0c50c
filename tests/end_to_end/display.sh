# For tests of the real window: source it first. The test runs again on a virtual display of its own,
# with the `program`, an empty `folder`, and `running`: a process to be killed at its end, if any.

program=${PROMENADE:?names the program to test}
[ -n "${DISPLAY_IS_OURS:-}" ] || exec env DISPLAY_IS_OURS=1 \
  xvfb-run -a -s "-screen 0 1280x720x24" "$0" "$@"

folder=$(mktemp -d)
running=
finish() {
  [ -z "$running" ] || kill "$running" 2>/dev/null || true
  rm -rf "$folder"
}
trap finish EXIT

expect() {  # expect SAID WANTED FOUND
  [ "$2" = "$3" ] || { echo "$1: wanted \"$2\", found \"$3\"" >&2; exit 1; }
}
