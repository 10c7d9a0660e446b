#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# suite.sh NAME RUNNER COMMAND…: runs a suite of tests, prints its line, and after a failure what failed. Leaves
# what it said in build/test-logs/NAME.log, and "passed failed" in NAME.count beside it.
set -uo pipefail
cd "$(dirname "$0")/.." || exit
name=$1 runner=$2
shift 2
logs=build/test-logs
log=$logs/$name.log
mkdir -p "$logs"
rm -f "$logs/$name.count"

status=0
"$@" >"$log" 2>&1 || status=$?
counted=$(scripts/count_tests.sh "$runner" "$log" "$status") || counted=
if ! [[ $counted =~ ^[0-9]+\ [0-9]+$ ]]; then
  echo "suite.sh: what $name reported cannot be counted: count_tests.sh $runner $log says '$counted'" | tee -a "$log" >&2
  counted="0 1"
fi
read -r pass fail <<<"$counted"
printf '%-14s %5d passed %3d failed  %4d s\n' "$name:" "$pass" "$fail" "$SECONDS"
echo "$counted" >"$logs/$name.count"
[ "$fail" -eq 0 ] || { echo "--- $log"; scripts/show_failures.sh "$log"; exit 1; }
