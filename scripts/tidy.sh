#!/usr/bin/env bash
# tidy.sh: clang-tidy over every source of the project. A file is looked at again only after it, a
# header of the project, or the configuration has changed.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build/tidy
headers=$(git ls-files -co --exclude-standard -- '*.h' .clang-tidy | sort | xargs sha256sum | sha256sum | cut -c1-16)

check() {
  local stamp="build/tidy/$(sha256sum "$1" | cut -c1-16)-$2"
  [ -e "$stamp" ] && return 0
  clang-tidy --quiet -p build "$1" 2>/dev/null && touch "$stamp"
}
export -f check
git ls-files -co --exclude-standard -- 'core/*.cpp' 'bhdl/*.cpp' 'robot/*.cpp' 'sim/*.cpp' 'monitor/*.cpp' 'front/*.cpp' |
  xargs -P2 -I{} bash -c 'check "$1" "$2"' _ {} "$headers"
