// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean::bhdl {

/// A right program for the robot's own components, laid out as those that ship: two devices, six
/// variables, three perceptual and four motor schemas, and a ring of `states` that are worth some
/// 450 bytes each.
[[nodiscard]] std::string generated_program(int states);

/// As much text of the same kind in JSON: what a robot would read if programs were JSON.
[[nodiscard]] std::string generated_json(int states);

}  // namespace galilean::bhdl
