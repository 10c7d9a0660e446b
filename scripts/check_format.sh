#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_format.sh: every C++ file is as clang-format leaves it.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/sources.sh '*.h' '*.cpp' | xargs clang-format --dry-run --Werror
