#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test: unit, language, wire, page, end to end, in
# the browser, under sanitizers, fuzzed, format and lint. Ends with one line: N passed, N failed.
#   ./test.sh [SUITE…]   only these (their names stand before the colons below)
set -uo pipefail
cd "$(dirname "$0")"

fails() { echo "0 passed, 1 failed"; exit 1; }
scripts/install.sh test || fails
# Not in the domain that a team on this machine may be using, nor another checkout's tests.
[ -n "${GALILEAN_TEST_DOMAIN:-}" ] || exec node tests/tools/with_domain.mjs ./test.sh "$@"
scripts/build.sh all || fails

passed=0 failed=0
logs=build/test-logs
mkdir -p "$logs"

# suite NAME COMMAND…: runs it and adds up what it reports; one that reports no count is one test.
suite() {
  local name=$1 log=$logs/$1.log status=0 pass fail
  shift
  local started=$SECONDS
  "$@" >"$log" 2>&1 || status=$?
  read -r pass fail < <(scripts/count_tests.sh "$log" "$status")
  passed=$((passed + pass)) failed=$((failed + fail))
  printf '%-14s %5d passed %3d failed  %4d s\n' "$name:" "$pass" "$fail" $((SECONDS - started))
  [ "$fail" -eq 0 ] || { echo "--- $log"; scripts/show_failures.sh "$log"; }
}

wanted() { [ ${#only[@]} -eq 0 ] || [[ " ${only[*]} " == *" $1 "* ]]; }
run() { if wanted "$1"; then suite "$@"; fi; }
only=("$@")

run unit ctest --test-dir build -j2 --output-on-failure
run page scripts/page.sh test
run page-types scripts/page.sh check
run node scripts/node_tests.sh tests/{logs,architecture,tools}/*.test.mjs
run end-to-end scripts/node_tests.sh tests/end_to_end/*.test.mjs
run browser scripts/browser_tests.sh
run sanitizers scripts/sanitize.sh address,undefined
run threads scripts/sanitize.sh thread
run fuzz scripts/fuzz.sh 30
run format scripts/check_format.sh
run tidy scripts/tidy.sh

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
