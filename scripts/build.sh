#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# build.sh demo|programs|all: builds the programs into build/ (with "demo" only those that the demo runs, with "all"
# the tests as well), and at the same time the page into build/share/galilean/web. Does only what changed.
set -euo pipefail
cd "$(dirname "$0")/.."
what=${1:-programs}
target=$what
[ "$what" = demo ] && target=demo_programs

configure() {
  local tests=OFF
  [ "$what" = all ] && tests=ON
  [ -f build/build.ninja ] && { [ $tests = OFF ] || grep -q 'GALILEAN_TESTS:BOOL=ON' build/CMakeCache.txt; } && return
  # Several files at a time: a first build takes half as long. For work on one file there is preset dev.
  cmake --preset release -DGALILEAN_TESTS=$tests >build.log 2>&1 || { cat build.log >&2; exit 1; }
  rm -f build.log
}

compile() {
  ninja -C build -n "$target" | grep -q 'no work to do' && return
  echo "Building …"
  # The page waits for the network and for one core at most: it goes first.
  nice ninja -C build "$target" >build/build.log 2>&1 && return
  grep -A20 -E 'FAILED|error' build/build.log | head -100 >&2
  return 1
}

# Two builds in one folder would undo each other's work.
alone() {
  exec 9>build/lock
  flock -n 9 || { echo "Waiting until another build has ended …"; flock 9; }
}

mkdir -p build
alone
scripts/build_page.sh "$what" &
page=$!
configure
compile || { kill $page 2>/dev/null; exit 1; }
wait $page
