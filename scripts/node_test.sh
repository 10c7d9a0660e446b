#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# node_test.sh FILE: runs a file of Node tests, and reports as TAP does. Beside a test that fails, it is a
# failure when the file registers no test, ends before its tests did, or has not ended after
# GALILEAN_TEST_LIMIT seconds (900).
set -uo pipefail
file=$1 limit=${GALILEAN_TEST_LIMIT:-900}
log=$(mktemp)
trap 'rm -f "$log"' EXIT

# Not by `node --test`: that counts a file without a test, or one that exits too early, as a test that passed.
# What the tests started ends with them, both at the limit and on Ctrl-C: timeout gives all of it a group.
run() {
  timeout --kill-after=10 "$limit" node --test-reporter=tap "$file" 2>&1 &
  trap "kill -TERM $!" INT TERM
  wait $!
}
count() { awk -v names="^# ($1) " '$0 ~ names {n += $3} END {print n + 0}' "$log"; }
fails() { # REASON
  echo "not ok - $file $1"
  echo "# fail 1"
  exit 1
}

status=0
(run) | tee "$log" || status=$?
case $status in
  0) ;;
  124 | 137) fails "was ended after $SECONDS s, the limit is $limit s: something in it waits for ever" ;;
esac
[ "$(count tests)" -gt 0 ] || fails "registered no test, or ended before its tests did (exit code $status)"
[ "$status" -eq 0 ] || [ "$(count 'fail|cancelled')" -gt 0 ] || fails "ended with exit code $status"
exit "$status"
