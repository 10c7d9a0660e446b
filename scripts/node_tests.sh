#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# node_tests.sh FILE…: runs Node tests one file after another, by Node 18; their packages stand in tests/node.
set -euo pipefail
cd "$(dirname "$0")/.."
[ tests/node/node_modules/.package-lock.json -nt tests/node/package-lock.json ] ||
  (cd tests/node && npm ci --no-audit --no-fund --silent)
status=0
for file in "$@"; do scripts/node18.sh scripts/node_test.sh "$file" || status=1; done
exit $status
