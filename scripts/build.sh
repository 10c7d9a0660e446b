#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# build.sh programs|all: builds the programs (and with "all" the tests) into build/, and the page
# into build/share/galilean/web, with "all" by Node 18. Does only what changed.
set -euo pipefail
cd "$(dirname "$0")/.."

tests=OFF
[ "${1:-programs}" = all ] && tests=ON
if [ ! -f build/build.ninja ] || { [ $tests = ON ] && ! grep -q 'GALILEAN_TESTS:BOOL=ON' build/CMakeCache.txt; }; then
  # Several files at a time: a first build takes half as long. For work on one file there is preset dev.
  cmake --preset release -DGALILEAN_TESTS=$tests >build.log 2>&1 || { cat build.log >&2; exit 1; }
  rm -f build.log
fi
target=programs
[ "${1:-programs}" = all ] && target=all
if ! ninja -C build -n "$target" | grep -q 'no work to do'; then
  echo "Building …"
  ninja -C build "$target" >build/build.log 2>&1 || { grep -A20 -E 'FAILED|error' build/build.log | head -100 >&2; exit 1; }
fi

# npm 11 misses other systems' optional packages in a lock without addresses, and `ci` then refuses it.
packages() {
  npm ci --no-audit --no-fund --silent || npm install --no-save --no-audit --no-fund --silent
}

stamp=build/share/galilean/web.stamp
# What the page is made of; its message types are made of the IDL.
sources=$(find web bhdl/editors core/wire/idl -path web/node_modules -prune -o -path web/dist -prune -o \
  -path 'web/src/feed/messages.ts*' -prune -o -type f -print0 | sort -z | xargs -0 sha256sum | sha256sum)
wanted=$sources shell=$(command -v bash)
[ "${1:-programs}" = all ] && wanted="$sources by Node 18" shell=$PWD/scripts/node18.sh
if [[ $(cat "$stamp" 2>/dev/null) != "$wanted"* ]]; then
  echo "Building the page …"
  (cd web && { [ node_modules/.package-lock.json -nt package-lock.json ] || packages; } &&
    npm run build --silent --script-shell "$shell") >build/web.log 2>&1 || { tail -40 build/web.log >&2; exit 1; }
  rm -rf build/share/galilean/web
  mkdir -p build/share/galilean
  cp -r web/dist build/share/galilean/web
  find build/share/galilean/web -type f -size +1k ! -name '*.png' ! -name '*.woff2' -exec gzip -9 -k -n {} +
  rm -rf build/share/galilean/vscode
  "$shell" -c 'node bhdl/editors/textmate.mjs build/share/galilean/vscode'
  echo "$wanted" >"$stamp"
fi
