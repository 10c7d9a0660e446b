// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string_view>

namespace galilean::msg {

/// Returns whether a robot may have this name: 1 to 64 letters, digits and _, the first no digit.
/// ROS 2 allows no other names in topics, and the robot's name is part of its topics' names.
[[nodiscard]] constexpr bool is_robot_name(std::string_view name) noexcept {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto is_allowed = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
  };
  return !name.empty() && name.size() <= 64 && !is_digit(name.front()) &&
         std::all_of(name.begin(), name.end(), is_allowed);
}

}  // namespace galilean::msg
