#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test.sh NAME [OPTION…]: builds and runs one test in the dev preset, and no more than it needs. NAME:
#   move_to_goal                 what tests a class or a schema: its suite, or the files that include its header
#   tests/robot/motor/goal_test  a file of tests;  goal_test does as well
#   motor_test                   a whole program of tests
#   MoveToGoalTest.Is*           tests by GoogleTest's names; * and ? stand for anything
# What follows goes to GoogleTest, such as --gtest_repeat=10. Node tests are run with
# scripts/node_tests.sh FILE, those in the browser with scripts/browser_tests.sh FILE.
set -euo pipefail
cd "$(dirname "$0")/.."
usage() { awk '/^[^#]/ { exit } NR > 1 && !/SPDX/ { sub(/^# ?/, ""); print }' "$0"; exit 2; }
[ $# -gt 0 ] || usage
name=$1
shift
dir=build/dev

# program_of FILE: the program whose build file lists this file of tests.
program_of() {
  local folder=${1%/*} listed
  while [ "$folder" != tests ] && [ -n "$folder" ]; do
    listed=${1#"$folder"/}
    if [ -f "$folder/CMakeLists.txt" ]; then
      awk -v file="$listed" '
        /galilean_test\(/ { sub(/.*galilean_test\(/, ""); program = $1; sub(/[ )].*/, "", program) }
        { for (i = 1; i <= NF; i++) { word = $i; gsub(/[()]/, "", word); if (word == file) { print program; exit } } }
      ' "$folder/CMakeLists.txt" | grep . && return
    fi
    folder=${folder%/*}
  done
  echo "test.sh: no program lists $1; add it to the CMakeLists.txt beside it" >&2
  return 1
}

# suites_of FILE…: GoogleTest's filter for the tests that these files hold.
suites_of() {
  sed -nE 's/^(TYPED_)?TEST(_F|_P)?\(([A-Za-z0-9_]+).*/\3/p' "$@" | sort -u | sed 's/.*/&.*:*\/&.*/' | paste -sd: -
}

filter= files=
if grep -rqsE "galilean_test\($name[ )]|galilean_test\($name\$" tests --include=CMakeLists.txt; then
  programs=$name
else
  if [ -f "${name%.cpp}.cpp" ]; then
    files=${name%.cpp}.cpp
  elif [[ $name == *.* ]]; then
    suite=${name%%.*} filter=$name
    files=$(grep -rlE "^(TYPED_)?TEST(_F|_P)?\(${suite//\*/.*}[,)]" tests --include='*.cpp' || true)
  else
    files=$(find tests -name "$name.cpp" -o -name "${name}_test.cpp")
    class=$(sed -E 's/(^|_)([a-z0-9])/\U\2/g' <<<"$name")
    suites="^(TYPED_)?TEST(_F|_P)?\\(${class}(Test)?,"
    if [ -z "$files" ] && files=$(grep -rlE "$suites" tests --include='*_test.cpp'); then
      filter="$class.*:${class}Test.*"
    fi
    [ -n "$files" ] || files=$(grep -rlE "#include \".*/$name\.h\"" tests --include='*_test.cpp' || true)
    # Schemas are tested by the name that programs call them by.
    [ -n "$files" ] || files=$(grep -rl "\"$name\"" tests/robot/{motor,perceptual} --include='*_test.cpp' || true)
  fi
  [ -n "$files" ] || { echo "test.sh: there is no test called $name" >&2; usage; }
  programs=$(for file in $files; do program_of "$file"; done | sort -u)
  # shellcheck disable=SC2086
  [ -n "$filter" ] || filter=$(suites_of $files)
fi

[ -f $dir/build.ninja ] || { echo "Configuring $dir …"; cmake --preset dev >build.log || { cat build.log; exit 1; }; rm -f build.log; }
# shellcheck disable=SC2086
ninja -C $dir $programs >$dir/build.log || { grep -A20 -E 'FAILED|error' $dir/build.log | head -60; exit 1; }
status=0
for program in $programs; do "$dir/tests/$program" --gtest_brief=1 ${filter:+"--gtest_filter=$filter"} "$@" || status=1; done
exit $status
