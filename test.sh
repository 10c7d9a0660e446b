#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds, and runs every test: unit, language, wire, page, end to end, in
# the browser, under sanitizers, fuzzed, with faults, format and lint. Ends with one line: N passed, N failed.
#   ./test.sh [SUITE…]   only these (their names stand behind `run` below)
set -uo pipefail
cd "$(dirname "$0")" || exit

suites=$(sed -nE 's/^run ([a-z-]+) .*/\1/p' test.sh)
for name in "$@"; do
  grep -qxF -e "$name" <<<"$suites" && continue
  echo "test.sh: there is no suite '$name': they are "$suites >&2
  exit 2
done

fails() { echo "0 passed, 1 failed"; exit 1; }
scripts/install.sh test || fails
# Not in the domain that a team on this machine may be using, nor another checkout's tests.
[ -n "${GALILEAN_TEST_DOMAIN:-}" ] || exec node tests/tools/with_domain.mjs ./test.sh "$@"
scripts/build.sh all || fails

only=("$@") passed=0 failed=0

# run NAME RUNNER COMMAND…: if it is wanted, and adds up what it reports. One that dies counts as failed.
run() {
  local pass fail
  [ ${#only[@]} -eq 0 ] || [[ " ${only[*]} " == *" $1 "* ]] || return 0
  scripts/suite.sh "$@"
  read -r pass fail 2>/dev/null <"build/test-logs/$1.count" || { pass=0 fail=1; }
  passed=$((passed + pass)) failed=$((failed + fail))
}

rm -f build/test-logs/*.count
run unit gtest scripts/unit_tests.sh
run page vitest scripts/page.sh test
run page-types status scripts/page.sh check
run node tap scripts/node_tests.sh tests/{logs,architecture,scripts,tools}/*.test.mjs
run end-to-end tap scripts/node_tests.sh tests/end_to_end/*.test.mjs
run browser tap scripts/browser_tests.sh
run sanitizers gtest scripts/sanitize.sh address,undefined
run threads gtest scripts/sanitize.sh thread
run fuzz tap scripts/fuzz.sh 144  # 10 s each
run faults tap scripts/faults.sh tests/faults/*.test.mjs
run format status scripts/check_format.sh
run tidy status scripts/tidy.sh

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
