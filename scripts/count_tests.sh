#!/usr/bin/env bash
# count_tests.sh LOG STATUS: prints "passed failed" from what ctest, GoogleTest, vitest or node's
# runner reported in LOG; a log without counts is one test that passed if STATUS is 0.
set -euo pipefail
log=$1 status=$2
sum() { sed 's/\x1b\[[0-9;]*m//g' "$log" | grep -oE "$1" | grep -oE '[0-9]+' | awk '{n += $1} END {print n + 0}'; }

if grep -qE 'tests (passed|failed).* out of' "$log"; then # ctest
  total=$(sum 'out of [0-9]+') fail=$(sum '[0-9]+ tests? failed')
  pass=$((total - fail))
elif grep -qE '^\[==========\] [0-9]+ tests? from' "$log"; then # GoogleTest, one program or several
  total=$(sum '^\[==========\] [0-9]+') pass=$(sum '^\[  PASSED  \] [0-9]+')
  fail=$((total - pass))
elif grep -qE '^(# |ℹ )pass ' "$log"; then # node --test
  pass=$(sum '^(# |ℹ )pass [0-9]+') fail=$(sum '^(# |ℹ )fail [0-9]+')
elif sed 's/\x1b\[[0-9;]*m//g' "$log" | grep -qE '^ +Tests +'; then # vitest
  line=$(sed 's/\x1b\[[0-9;]*m//g' "$log" | grep -E '^ +Tests +' | tail -1)
  pass=$(grep -oE '[0-9]+ passed' <<<"$line" | grep -oE '[0-9]+' || echo 0)
  fail=$(grep -oE '[0-9]+ failed' <<<"$line" | grep -oE '[0-9]+' || echo 0)
else
  pass=$((status == 0)) fail=0
fi
# A runner that failed without naming a test has failed all the same.
[ "$status" -ne 0 ] && [ "$fail" -eq 0 ] && fail=1
echo "$pass $fail"
