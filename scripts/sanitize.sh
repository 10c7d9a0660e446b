#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# sanitize.sh address,undefined|thread: builds the unit tests with these sanitizers and runs them.
# ThreadSanitizer runs what has threads (THREADS in the tests' CMakeLists.txt). Cyclone is not built with
# it: tests/sanitizers/thread.supp names what it then reports wrongly.
set -euo pipefail
cd "$(dirname "$0")/.."
kind=$1
preset=asan
[ "$kind" = thread ] && preset=tsan
dir=build/$preset

# The preset asan takes clang, which compiles the checks faster than g++, and is a second opinion; tsan takes
# g++, since under clang's ThreadSanitizer a test could not count allocations: operator new is its own there.
cmake --preset $preset >"$dir.log" 2>&1 || { cat "$dir.log"; exit 1; }
target=unit_tests
[ "$kind" = thread ] && target=thread_tests
ninja -C "$dir" $target >"$dir/build.log" 2>&1 || { grep -A20 -E 'FAILED|error' "$dir/build.log" | head -100; exit 1; }

export UBSAN_OPTIONS=print_stacktrace=1 TSAN_OPTIONS="halt_on_error=1 suppressions=$PWD/tests/sanitizers/thread.supp"
label=unit
[ "$kind" = thread ] && label=threads
scripts/unit_tests.sh "$dir" "$label"
