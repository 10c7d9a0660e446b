#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# faults.sh FILE…: runs files of tests/faults, by Node 18. What times wheels or answers has the machine for itself. The
# files that mostly wait, for processes, networks and disks, run at the same time, after it. Reports as TAP does.
set -uo pipefail
cd "$(dirname "$0")/.."
scripts/packages.sh tests/node || exit

status=0 waiting=()
for file in "$@"; do
  case $file in
    */process.test.mjs | */network.test.mjs | */disk.test.mjs) waiting+=("$file") ;;
    *) scripts/node_tests.sh "$file" || status=1 ;;
  esac
done

logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
processes=()
# A group each, since what a shell runs in the background hears no Ctrl-C.
end_all() { for process in "${processes[@]}"; do kill -TERM -- "-$process" 2>/dev/null; done; }
trap end_all INT TERM
for i in "${!waiting[@]}"; do
  setsid scripts/node_tests.sh "${waiting[i]}" >"$logs/$i" 2>&1 &
  processes+=($!)
done
for i in "${!waiting[@]}"; do
  wait "${processes[i]}" || status=1
  cat "$logs/$i"
done
exit $status
