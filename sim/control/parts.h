// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "sim/world/broken_parts.h"

namespace galilean::sim {

/// Breaks a part: "camera", "serial_line", "board", "left_wheel", "right_wheel" or "bumper_0" …
/// "bumper_7". `fault` is "dead", which an empty text means as well, or for a bumper "stuck".
/// Errors: there is no such part, or it cannot break in this way.
Result<void> break_part(BrokenParts& broken, const std::string& part, const std::string& fault);
/// Errors: there is no such part, or it is not broken.
Result<void> mend_part(BrokenParts& broken, const std::string& part);

struct PartFault {
  std::string part;
  std::string fault;
};
/// Returns what is broken, in a fixed order.
[[nodiscard]] std::vector<PartFault> faults_of(const BrokenParts& broken);

}  // namespace galilean::sim
