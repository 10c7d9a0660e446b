// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/result.h"

namespace galilean {

/// How deep JSON may nest that is read. Copying and printing JSON recurse into it: text that nests
/// a million levels deep would exhaust the stack. The project's own messages are flatter.
inline constexpr int kDeepestJson = 32;

/// How much JSON is read. Text beyond it is refused before anything is made of it, because a value
/// takes many times the memory and the time of the two bytes that it may be written with.
struct JsonLimits {
  std::size_t bytes = std::size_t{64} << 20;  ///< of the text
  std::size_t values = 1'000'000;             ///< in all, of which containers are some
};

/// Reads JSON that came from outside. Any text may be given. The result is safe to copy, compare
/// and print. Errors: the text is not JSON in UTF-8, it nests deeper than kDeepestJson, or it
/// exceeds `limits`. The error is one sentence.
[[nodiscard]] Result<nlohmann::json> read_untrusted_json(std::string_view text,
                                                         const JsonLimits& limits = {});

/// Reads JSON of a file or of a program's output. Errors: as read_untrusted_json; the error is a
/// clause without a full stop that says what is wrong, with the byte where the text is not JSON, so
/// that the file's name can stand before it.
[[nodiscard]] Result<nlohmann::json> read_json(std::string_view text);

/// Returns the JSON as text: on one line, or with a line a value where `indent` is the number of
/// spaces of a level. Bytes from outside that are not UTF-8 become U+FFFD. Files call this in place
/// of dump, which each of them would compile anew.
[[nodiscard]] std::string json_text(const nlohmann::json& json, int indent = -1);
[[nodiscard]] std::string ordered_json_text(const nlohmann::ordered_json& json, int indent = -1);

}  // namespace galilean
