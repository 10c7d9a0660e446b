// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// A way out of a state, as a picture shows it: neighbouring conditions that differ in nothing but
/// bits in a row are one, "bumpers[0-7] is 1".
struct Way {
  std::string cause;
  std::string to;
};

/// In the order in which they are tried.
[[nodiscard]] std::vector<Way> ways_out(const State& state);

}  // namespace galilean::bhdl
