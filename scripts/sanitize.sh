#!/usr/bin/env bash
# sanitize.sh address,undefined|thread: builds the unit tests with these sanitizers and runs them.
# ThreadSanitizer runs what has threads alone; Cyclone itself is not built with it, hence its list
# of suppressions.
set -euo pipefail
cd "$(dirname "$0")/.."
kind=$1
dir=build/sanitize-${kind%%,*}
cmake -S . -B "$dir" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DGALILEAN_SANITIZE="$kind" >/dev/null
ninja -C "$dir" unit_tests >"$dir/build.log" 2>&1 || { tail -60 "$dir/build.log"; exit 1; }
export ASAN_OPTIONS=detect_stack_use_after_return=1
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS="suppressions=$PWD/tests/thread_suppressions.txt halt_on_error=1"
if [ "$kind" = thread ]; then
  exec ctest --test-dir "$dir" -j2 --output-on-failure -L threads
fi
exec ctest --test-dir "$dir" -j2 --output-on-failure -L unit
