#!/usr/bin/env bash
# browser_tests.sh [FILE…]: runs the browser tests (all, or these of tests/browser) one file after
# another on the page of one demo, which it starts and ends.
set -euo pipefail
cd "$(dirname "$0")/.."
[ -n "${GALILEAN_TEST_DOMAIN:-}" ] || exec node tests/tools/with_domain.mjs scripts/browser_tests.sh "$@"
files=("$@")
[ $# -gt 0 ] || files=(tests/browser/*.test.mjs)
port=$(node --input-type=module -e 'console.log(await (await import("./tests/tools/port.mjs")).freePort())')
folder=$(mktemp -d)
export XDG_STATE_HOME=$folder/state

(cd "$folder" && exec "$OLDPWD/build/bin/galilean" demo --port "$port" --seed 3 >"$folder/demo.log" 2>&1) &
demo=$!
leave() { kill -INT $demo 2>/dev/null || true; wait $demo 2>/dev/null || true; rm -rf "$folder"; }
trap leave EXIT
until grep -q "http://127.0.0.1:$port" "$folder/demo.log"; do
  kill -0 $demo 2>/dev/null || { cat "$folder/demo.log"; exit 1; }
  read -rt 0.2 <> <(:) || true
done
# The demo's own link: with the token that lets its reader steer.
GALILEAN_URL=$(grep -o "http://127.0.0.1:$port[^ ]*" "$folder/demo.log" | head -n 1)
export GALILEAN_URL
if [[ " ${files[*]} " == *recorded.test.mjs* ]]; then
  export GALILEAN_RECORDING=$folder/recorded.mcap
  build/bin/galilean record --out "$GALILEAN_RECORDING" --duration 15
fi
scripts/node_tests.sh "${files[@]}"
