// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace galilean::monitor {

/// Returns the kinds of msg::Command by their names in requests, such as "hold".
[[nodiscard]] const std::map<std::string, std::uint8_t>& command_kinds();

}  // namespace galilean::monitor
