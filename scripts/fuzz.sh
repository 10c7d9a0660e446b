#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# fuzz.sh [SECONDS]: builds the fuzzers with clang and runs them for SECONDS (600) in all, two at a time, each
# from its own inputs in tests/fuzz/corpora, or from those in tests/fuzz/corpus, the cases and the programs that
# ship. An input that takes 10 s or 1 GiB breaks it, too. What breaks one is left in build/fuzz/findings; run the
# fuzzer with that file to see it again. Reports as TAP does.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-600}
fuzzers=(check format diff language_server expect messages mcap recover schemas
  http websocket foxglove serial scenario tokens history)
dir=build/fuzz

mkdir -p "$dir/findings"
cmake --preset fuzz >"$dir/configure.log" 2>&1 || { cat "$dir/configure.log"; exit 1; }
ninja -C "$dir" fuzzers >"$dir/build.log" 2>&1 || { grep -A20 -E 'FAILED|error' "$dir/build.log" | head -100; exit 1; }

passed=0 failed=0

# inputs_of NAME: the folders of its first inputs, a line each.
inputs_of() {
  if [ -d "tests/fuzz/corpora/$1" ]; then
    echo "tests/fuzz/corpora/$1"
    [ "$1" != scenario ] || echo sim/scenarios
  else
    printf '%s\n' tests/fuzz/corpus tests/cases bhdl/programs
  fi
}

# fuzz NAME: leaves what it said in NAME.log.
fuzz() {
  local inputs dict=tests/fuzz/bhdl.dict
  mapfile -t inputs < <(inputs_of "$1")
  [ ! -f "tests/fuzz/$1.dict" ] || dict=tests/fuzz/$1.dict
  mkdir -p "$dir/found/$1"
  "$dir/tests/fuzz/${1}_fuzz" -max_total_time=$((seconds / ${#fuzzers[@]} + 1)) -max_len=20000 \
    -timeout=10 -rss_limit_mb=1024 -dict="$dict" -print_final_stats=1 \
    -artifact_prefix="$dir/findings/$1-" "$dir/found/$1" "${inputs[@]}" >"$dir/$1.log" 2>&1
}

# judge NAME PROCESS: waits for its end.
judge() {
  if wait "$2"; then
    passed=$((passed + 1))
    echo "ok $((passed + failed)) - $1: $(awk '/number_of_executed_units/ {print $2}' "$dir/$1.log") inputs"
  else
    failed=$((failed + 1))
    echo "not ok $((passed + failed)) - $1"
    tail -40 "$dir/$1.log"
  fi
}

for ((first = 0; first < ${#fuzzers[@]}; first += 2)); do
  processes=()
  for name in "${fuzzers[@]:first:2}"; do
    fuzz "$name" &
    processes+=($!)
  done
  for i in "${!processes[@]}"; do judge "${fuzzers[first + i]}" "${processes[i]}"; done
done
echo "# pass $passed"
echo "# fail $failed"
[ "$failed" -eq 0 ]
