// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::bhdl {

/// A place in a program. Line and column count from 1.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;
};

}  // namespace galilean::bhdl
