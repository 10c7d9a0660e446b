// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "bhdl/diff/diff.h"
#include "bhdl/graph/graph.h"
#include "bhdl/program/machine.h"
#include "tests/bhdl/small_catalog.h"
#include "tests/fuzz/input.h"

// The input is two programs with a NUL byte between them. Their differences must be printable in
// words and as JSON, and their states drawable.

using namespace galilean::bhdl;

namespace {

void draw(const Program& program) {
  must(!to_dot(program).empty() && !to_svg(program).empty(), "every program can be drawn");
  must(!nlohmann::json(program).dump().empty(), "every program can be told as JSON");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto catalog = small_catalog();
  const auto files = files_of(data, size);
  const auto from = check({files.front()}, catalog).program;
  const auto to = check({files.back()}, catalog).program;
  if (!from || !to) return 0;
  draw(*from);
  must(differences(*from, *from, catalog).empty(), "a program does what it does");
  const auto there = differences(*from, *to, catalog);
  const auto back = differences(*to, *from, catalog);
  must(there.empty() == back.empty(), "who differs from whom does not matter");
  for (const auto& change : there)
    must(!in_words(change).empty() && !nlohmann::json(change).empty(), "every change has words");
  return 0;
}
