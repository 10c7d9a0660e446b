// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/result.h"

namespace galilean {

/// How deep read_untrusted_json lets JSON nest. Copying and printing JSON recurse into it: text
/// that nests a million levels deep would exhaust the stack. The project's own messages are
/// flatter.
inline constexpr int kDeepestJson = 64;

/// Reads JSON that came from outside. Any text may be given. The result is safe to copy, compare
/// and print. Errors: the text is not JSON in UTF-8, or it nests deeper than kDeepestJson. The
/// error is one sentence.
[[nodiscard]] Result<nlohmann::json> read_untrusted_json(std::string_view text);

/// Returns the JSON as text on one line. Bytes from outside that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_text(const nlohmann::json& json);

}  // namespace galilean
