#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# count_tests.sh RUNNER LOG STATUS: prints "passed failed", of what a runner reported in LOG before it ended
# with STATUS. RUNNER is ctest, gtest (GoogleTest, one program or several), vitest or tap (Node's runner);
# `status` is for what tells no number: it is one test. A test that did not run, be it cancelled, skipped,
# disabled or left for later, has failed. So has a run without a test, and a runner that names no failed one.
set -euo pipefail
runner=$1 log=$2 status=$3
text=$(sed 's/\x1b\[[0-9;]*m//g' "$log")

# sum PATTERN: of what its group matches, line by line.
sum() { sed -nE "s/$1/\1/p" <<<"$text" | awk '{n += $1} END {print n + 0}'; }
lines() { sed -nE "/$1/p" <<<"$text" | wc -l; }

case $runner in
  ctest)
    skipped=$(lines '^\s+[0-9]+ - .* \(Skipped\)$') # counts as passed there; what is disabled, as nothing
    failed=$(sum '^[0-9]+% tests passed, ([0-9]+) tests? failed out of [0-9]+$')
    pass=$(($(sum '^[0-9]+% tests passed, .* out of ([0-9]+)$') - failed - skipped))
    fail=$((failed + skipped + $(lines '^\s+[0-9]+ - .* \(Disabled\)$')))
    ;;
  gtest)
    pass=$(sum '^\[  PASSED  \] ([0-9]+) tests?\..*')
    fail=$(($(sum '^\[={10}\] ([0-9]+) tests? from .*') - pass + $(sum '^ *YOU HAVE ([0-9]+) DISABLED .*')))
    fail=$((fail + $(lines '^\[={10}\] 0 tests from ')))
    ;;
  vitest)
    pass=$(sum '^ +Tests .* ([0-9]+) passed .*')
    fail=$(($(sum '^ +Tests .*\(([0-9]+)\)$') - pass))
    ;;
  tap)
    pass=$(sum '^# pass ([0-9]+)$') fail=0
    for kind in fail cancelled skipped todo; do fail=$((fail + $(sum "^# $kind ([0-9]+)$"))); done
    ;;
  status) pass=$((status == 0)) fail=$((status != 0)) ;;
  *)
    echo "count_tests.sh: there is no runner '$runner': it is ctest, gtest, vitest, tap or status" >&2
    exit 2
    ;;
esac
if [ "$fail" -eq 0 ] && { [ "$status" -ne 0 ] || [ "$pass" -eq 0 ]; }; then fail=1; fi
echo "$pass $fail"
