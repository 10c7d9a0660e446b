#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# install.sh build|page|test: installs what packages.txt lists under this name, "test" everything, and
# this machine lacks. Root or sudo.
set -euo pipefail
cd "$(dirname "$0")/.."

sections="[${1:-build}]"
[ "$sections" = "[test]" ] && sections="[build] [page] [test]"
wanted=$(awk -v sections="$sections" '/^\[/ {on = index(sections, $1)} /^[a-z]/ && on' packages.txt)

# Another Node than Debian's serves as well, and would be broken by Debian's npm beside it.
if command -v node >/dev/null && command -v npm >/dev/null; then
  major=$(node -p 'process.versions.node.split(".")[0]')
  [ "$major" -ge 18 ] && wanted=$(grep -vxE 'nodejs|npm' <<<"$wanted" || true)
fi

missing=$(for package in $wanted; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || echo "$package"
done)
[ -z "$missing" ] && exit 0

as_root=
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "install.sh: not root and no sudo; as root run: apt-get install" $missing >&2; exit 1; }
  as_root=sudo
fi
echo "Installing $(wc -w <<<"$missing") packages …"
log=$(mktemp)
# No recommended packages: some of them bring Qt.
if ! { $as_root apt-get update -qq && $as_root env DEBIAN_FRONTEND=noninteractive \
       apt-get install -y -qq --no-install-recommends $missing; } >"$log" 2>&1; then
  tail -20 "$log" >&2
  echo "install.sh: apt-get failed; the log above says why" >&2
  exit 1
fi
rm -f "$log"
