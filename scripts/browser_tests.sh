#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# browser_tests.sh [FILE…]: runs the browser tests (all, or these of tests/browser) one file after
# another. Those that want a live team come first, on the page of one demo that starts and ends with
# them: its contest is soon over. How the demo fared is a test of its own.
set -euo pipefail
cd "$(dirname "$0")/.."
[ -n "${GALILEAN_TEST_DOMAIN:-}" ] || exec node tests/tools/with_domain.mjs scripts/browser_tests.sh "$@"
files=("$@")
[ $# -gt 0 ] || files=(tests/browser/*.test.mjs)
live=() played=()
for file in "${files[@]}"; do
  if grep -qE 'liveTab|GALILEAN_(URL|RECORDING)' "$file"; then live+=("$file"); else played+=("$file"); fi
done

folder=$(mktemp -d)
export XDG_STATE_HOME=$folder/state
trap 'rm -rf "$folder"' EXIT

# Leaves the demo's process in `demo`, and its link and a recording of it to the tests.
start_demo() {
  local port
  port=$(node --input-type=module -e 'console.log(await (await import("./tests/tools/port.mjs")).freePort())')
  touch "$folder/demo.log"
  (cd "$folder" && exec "$OLDPWD/build/bin/galilean" demo --port "$port" --seed 3 >"$folder/demo.log" 2>&1) &
  demo=$!
  trap 'end_demo; rm -rf "$folder"' EXIT
  until grep -q "http://127.0.0.1:$port" "$folder/demo.log"; do
    kill -0 $demo 2>/dev/null || { cat "$folder/demo.log"; exit 1; }
    read -rt 0.2 <> <(:) || true
  done
  # The demo's own link: with the token that lets its reader steer.
  GALILEAN_URL=$(grep -o "http://127.0.0.1:$port[^ ]*" "$folder/demo.log" | head -n 1)
  GALILEAN_RECORDING=$folder/recorded.mcap
  export GALILEAN_URL GALILEAN_RECORDING
  [[ " ${live[*]} " != *recorded.test.mjs* ]] || record_demo
}

# Pictures that are lost on a busy machine, which is what 3 tells, are no reason to fail.
record_demo() {
  build/bin/galilean record --out "$GALILEAN_RECORDING" --duration 15 || [ $? -eq 3 ]
}

# Leaves in `ending` how it ended: its exit code, with "early" before it if it did so by itself.
end_demo() {
  local code=0
  ending=
  kill -INT $demo 2>/dev/null || ending="early "
  timeout 60 tail --pid=$demo -f /dev/null || kill -KILL $demo
  wait $demo 2>/dev/null || code=$?
  ending+=$code
}

status=0
if [ ${#live[@]} -gt 0 ]; then
  start_demo
  scripts/node_tests.sh "${live[@]}" || status=1
  end_demo
  trap 'rm -rf "$folder"' EXIT
  scripts/judge_demo.sh "$folder" "$ending" || status=1
fi
[ ${#played[@]} -eq 0 ] || scripts/node_tests.sh "${played[@]}" || status=1
exit $status
