// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// A way out of a state, as a picture shows it. Neighbouring conditions that differ only in
/// consecutive bits are one way: "bumpers[0-7] is 1".
struct Way {
  std::string cause;
  std::string to;
};

/// Returns the ways in the order in which they are tried.
[[nodiscard]] std::vector<Way> ways_out(const State& state);

}  // namespace galilean::bhdl
