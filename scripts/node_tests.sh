#!/usr/bin/env bash
# node_tests.sh FILE…: runs Node tests one after another; their packages stand in tests/node.
set -euo pipefail
cd "$(dirname "$0")/.."
[ tests/node/node_modules/.package-lock.json -nt tests/node/package-lock.json ] ||
  (cd tests/node && npm ci --no-audit --no-fund --silent)
status=0
for file in "$@"; do node --test "$file" || status=1; done
exit $status
