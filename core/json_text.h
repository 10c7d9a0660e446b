// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/result.h"

namespace galilean {

/// Copying and printing JSON recurses into it: text that nests a million levels deep would exhaust
/// the stack. No message of the project's nests as deep as this.
inline constexpr int kDeepestJson = 64;

/// Reads JSON that came from outside. Any text is safe to read so, and what is returned is safe to
/// copy, compare and print.
/// Errors: the text is not JSON in UTF-8; it nests deeper than kDeepestJson. One sentence.
[[nodiscard]] Result<nlohmann::json> read_untrusted_json(std::string_view text);

/// Returns JSON's text on one line, of anything: bytes from outside that are not UTF-8 become
/// U+FFFD.
[[nodiscard]] std::string json_text(const nlohmann::json& json);

}  // namespace galilean
