#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# tidy.sh: clang-tidy over every C++ source outside of tests/. It spends most of its time in the
# system's headers, so it gets many sources at a time, as a unity build batches them.
set -euo pipefail
cd "$(dirname "$0")/.."
dir=build/tidy
mkdir -p "$dir"

# What was clean stays so for the same sources, to the same clang-tidy, asked in the same way.
stamp=$({
  clang-tidy --version
  cat scripts/tidy.sh scripts/sources.sh
  scripts/sources.sh '*.h' '*.cpp' '*.idl' CMakeLists.txt '*.cmake' CMakePresets.json .clang-tidy | xargs sha256sum
} | sha256sum)
[ "$(cat "$dir/clean" 2>/dev/null)" = "$stamp" ] && exit 0

# clang cannot read what g++ precompiles.
cmake --preset tidy >"$dir/cmake.log" 2>&1 || { cat "$dir/cmake.log"; exit 1; }
ninja -C "$dir" galilean_wire >"$dir/build.log" 2>&1 || { tail -40 "$dir/build.log"; exit 1; }

node -p 'JSON.parse(fs.readFileSync(process.argv[1])).map((entry) => entry.file).join("\n")' "$dir/compile_commands.json" |
  grep -E '\.(cpp|cxx)$' | grep -vE '/generate/|/generated/|idl_compiler' |
  xargs -P2 -n1 clang-tidy --quiet --extra-arg=-Wno-unknown-warning-option \
    --extra-arg=-Wno-unused-command-line-argument -p "$dir" 2>/dev/null || exit 1
echo "$stamp" >"$dir/clean"
