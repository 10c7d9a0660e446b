// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace galilean::monitor {

/// Splits a schema in MCAP's encoding "ros2idl" into its words, numbers, texts and signs, without
/// comments, preprocessor lines and the lines between its parts ("====", "IDL: …"). Names keep
/// their scopes: "geometry_msgs::msg::Point" is one word. Any text may be given.
[[nodiscard]] std::vector<std::string_view> idl_tokens(std::string_view text);

}  // namespace galilean::monitor
