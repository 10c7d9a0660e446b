#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# sources.sh PATTERN…: the files of the tree whose names match, without what is built or installed.
# A tree without its git history has sources too, so git is not asked.
set -euo pipefail
cd "$(dirname "$0")/.."
names=()
for pattern in "$@"; do names+=(-o -name "$pattern"); done
find . \( -name .git -o -name node_modules -o -path './build*' -o -path ./web/dist -o -path './web/src/feed/messages.ts*' \) -prune -o \
  -type f \( "${names[@]:1}" \) -printf '%P\n' | sort
