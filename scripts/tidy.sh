#!/usr/bin/env bash
# tidy.sh [FOLDER…]: clang-tidy over the sources of these folders (all that are C++). A file is looked
# at again only after it, a header of the project, or the configuration has changed.
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p build/tidy
# clang cannot read what g++ precompiled.
sed -E 's/ -Winvalid-pch| -include [^ ]*cmake_pch.hxx//g' build/compile_commands.json >build/tidy/compile_commands.json
headers=$(git ls-files -co --exclude-standard -- '*.h' .clang-tidy | sort | xargs sha256sum | sha256sum | cut -c1-16)

check() {
  local stamp="build/tidy/$(sha256sum "$1" | cut -c1-16)-$2"
  [ -e "$stamp" ] && return 0
  clang-tidy --quiet --extra-arg=-Wno-unknown-warning-option -p build/tidy "$1" 2>/dev/null && touch "$stamp"
}
export -f check
folders=("$@")
[ ${#folders[@]} -gt 0 ] || folders=(core bhdl robot sim monitor front)
git ls-files -co --exclude-standard -- "${folders[@]/%//*.cpp}" |
  grep -v /generate/ | xargs -P2 -I{} bash -c 'check "$1" "$2"' _ {} "$headers"
