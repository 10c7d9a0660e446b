#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# node_tests.sh FILE…: runs Node tests one file after another, by Node 18; their packages stand in tests/node.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/packages.sh tests/node
status=0
for file in "$@"; do scripts/node18.sh scripts/node_test.sh "$file" || status=1; done
exit $status
