// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::front {

/// The path of a program that lies beside this one.
[[nodiscard]] std::string sibling(std::string_view program);
/// Returns whether the file exists and may be executed.
[[nodiscard]] bool is_program(const std::string& path);

}  // namespace galilean::front
