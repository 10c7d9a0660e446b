#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# judge_demo.sh FOLDER ENDING: tells as TAP whether a demo, whose own log is FOLDER/demo.log, ran without a fault
# until it was asked to end. ENDING is its exit code, with "early" before it if nobody had asked.
set -uo pipefail
folder=$1 ending=$2

# What the demo complains of, such as a process that died, with what follows. Then what the processes complain of,
# log as an error, or die of; their first word on a good start is a link.
faults() {
  case $ending in
    0) ;;
    early*) echo "the demo ended by itself, with exit code ${ending#early }" ;;
    *) echo "the demo ended with exit code $ending" ;;
  esac
  sed -n '/^galilean-demo: /,$p' "$folder/demo.log" 2>&1
  compgen -G "$folder/.galilean/run-*/*.log" >/dev/null || echo "none of its processes has left a log"
  grep -HE '^[0-9:.]+ (error|critical) |^galilean-[a-z]+: ([^h]|h[^t])|^terminate called|Sanitizer' \
    "$folder"/.galilean/run-*/*.log 2>/dev/null | sed 's|^.*/run-[0-9]*/||'
}

found=$(faults)
if [ -z "$found" ]; then
  printf 'ok - the demo ran without a fault\n# pass 1\n'
else
  printf 'not ok - the demo ran without a fault\n%s\n# fail 1\n' "$(sed 's/^/  /' <<<"$found")"
  exit 1
fi
