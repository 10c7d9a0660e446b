// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::bhdl {

/// Returns a correct program for the robot's own components, formatted like those that ship: two
/// devices, six variables, three perceptual and four motor schemas, and a ring of `states` states.
/// Each state has some 450 bytes.
[[nodiscard]] std::string generated_program(int states);

/// Returns a text of the same kind and size in JSON, which a robot would read if programs were
/// JSON.
[[nodiscard]] std::string generated_json(int states);

}  // namespace galilean::bhdl
