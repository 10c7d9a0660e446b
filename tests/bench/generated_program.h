// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::bhdl {

/// Returns a program without errors for the robot's own components. It is laid out as the programs
/// that ship: two devices, six variables, three perceptual and four motor schemas, and a ring of
/// `states` states of about 450 bytes each.
[[nodiscard]] std::string generated_program(int states);

/// Returns about as much text of the same kind in JSON, which a robot would read if programs were
/// JSON.
[[nodiscard]] std::string generated_json(int states);

}  // namespace galilean::bhdl
