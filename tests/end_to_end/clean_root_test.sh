#!/usr/bin/env bash
# tools/package-test on the built program, only where PROMENADE_CLEAN_ROOT=1 asks for it: it fetches
# a Debian and takes minutes.
set -euo pipefail

if [ "${PROMENADE_CLEAN_ROOT:-0}" != 1 ]; then
  echo "skipped: PROMENADE_CLEAN_ROOT=1 installs the package into a clean Debian 12, in minutes"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cpack --config "$(dirname "$PROMENADE")/package/CPackConfig.cmake" -B "$folder" > "$folder/log" ||
  { cat "$folder/log"; exit 1; }
"$PROMENADE_SOURCE_DIR/tools/package-test" "$folder"/promenade_*.deb
