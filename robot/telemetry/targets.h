// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace galilean::robot {

/// Returns whether a message to `targets` is meant for `robot`. No targets means every robot.
[[nodiscard]] inline bool is_meant(const std::string& robot,
                                   const std::vector<std::string>& targets) {
  return targets.empty() || std::ranges::find(targets, robot) != targets.end();
}

}  // namespace galilean::robot
