// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/check.h"
#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {

/// Returns a program of one state, of a file that is called `file`.
inline bhdl::Program own_program(const std::string& file, const std::string& state) {
  return bhdl::check({{file, "state: name: \"" + state + "\" end\n"}}, test_components().catalog())
      .program.value();
}

}  // namespace galilean::robot
