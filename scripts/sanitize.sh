#!/usr/bin/env bash
# sanitize.sh address,undefined|thread: builds unit tests with these sanitizers and runs them.
# ThreadSanitizer runs what has threads and no DDS: Cyclone is not built with it, and its locks
# would all look like races.
set -euo pipefail
cd "$(dirname "$0")/.."
kind=$1
dir=build/sanitize-${kind%%,*}
tests="core_test firmware_test devices_test bhdl_test vision_test"
[ "$kind" = thread ] && tests="core_test devices_test"

cmake -S . -B "$dir" -G Ninja -DGALILEAN_PARTS="core;bhdl;robot" -DGALILEAN_SANITIZE="$kind" \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" >"$dir.log" 2>&1 ||
  { cat "$dir.log"; exit 1; }
ninja -C "$dir" $tests >"$dir/build.log" 2>&1 || { tail -60 "$dir/build.log"; exit 1; }

export UBSAN_OPTIONS=print_stacktrace=1 TSAN_OPTIONS=halt_on_error=1
status=0
for test in $tests; do
  "$dir/tests/$test" --gtest_brief=1 || status=1
done
exit $status
