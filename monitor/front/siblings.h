// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::front {

/// Returns the path of a program in the folder of the running program. The file may be missing.
[[nodiscard]] std::string sibling(std::string_view program);
/// Returns whether the file exists and may be executed.
[[nodiscard]] bool is_program(const std::string& path);

}  // namespace galilean::front
