#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# unit_tests.sh [DIR [LABEL]]: runs the programs of tests that are built in DIR (build), all or those whose label
# matches LABEL, two at a time. Reports as GoogleTest does.
set -euo pipefail
cd "$(dirname "$0")/.."
# ctest's own count would be one of programs: GoogleTest's lines stay, without the number in front.
ctest --test-dir "${1:-build}" ${2:+-L "$2"} -j2 -V --no-tests=error | sed -E 's/^[0-9]+: //; /tests? (passed|failed).* out of/d'
