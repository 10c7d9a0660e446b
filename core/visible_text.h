// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean {

/// Returns the text as it can be shown on a terminal or in a message. Characters that are
/// invisible, look like a blank, or control a terminal or the direction of the text become their
/// codes, such as U+200B. Line ends are such characters, too. A byte that breaks UTF-8 becomes its
/// value, such as 0xFF.
[[nodiscard]] std::string visible(std::string_view text);

}  // namespace galilean
