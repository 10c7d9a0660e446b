#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# build_page.sh demo|programs|all: builds the page into build/share/galilean/web, with "all" by Node 18, and the
# words of editors beside it. Installs Node where there is none. Does only what changed.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install.sh page

stamp=build/share/galilean/web.stamp
# What the page is made of; its message types are made of the IDL.
sources=$(find web bhdl/editors core/wire/idl -path web/node_modules -prune -o -path web/dist -prune -o \
  -path 'web/src/feed/messages.ts*' -prune -o -type f -print0 | sort -z | xargs -0 sha256sum | sha256sum)
wanted=$sources shell=$(command -v bash)
[ "${1:-programs}" = all ] && wanted="$sources by Node 18" shell=$PWD/scripts/node18.sh
[[ $(cat "$stamp" 2>/dev/null) == "$wanted"* ]] && exit 0

echo "Building the page …"
scripts/packages.sh web
(cd web && npm run build --silent --script-shell "$shell") >build/web.log 2>&1 || { tail -40 build/web.log >&2; exit 1; }
rm -rf build/share/galilean/web
mkdir -p build/share/galilean
cp -r web/dist build/share/galilean/web
find build/share/galilean/web -type f -size +1k ! -name '*.png' ! -name '*.woff2' -exec gzip -9 -k -n {} +
rm -rf build/share/galilean/vscode
"$shell" -c 'node bhdl/editors/textmate.mjs build/share/galilean/vscode'
echo "$wanted" >"$stamp"
