// SPDX-License-Identifier: BSD-3-Clause
#include "core/json_text.h"

namespace galilean {
namespace {

/// Returns whether brackets outside strings nest deeper than kDeepestJson. The answer is exact
/// where the text is JSON. It is found before parsing, because the parser would build a value for
/// every bracket of a hostile text.
bool nests_too_deep(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char at = text[i];
    if (at == '"')
      in_string = !in_string;
    else if (in_string && at == '\\')
      ++i;
    else if (!in_string && (at == '[' || at == '{') && ++depth > kDeepestJson)
      return true;
    else if (!in_string && (at == ']' || at == '}'))
      --depth;
  }
  return false;
}

}  // namespace

Result<nlohmann::json> read_untrusted_json(std::string_view text) {
  if (nests_too_deep(text))
    return Error{"This JSON nests deeper than " + std::to_string(kDeepestJson) + " levels."};
  auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return Error{"This is not JSON in UTF-8."};
  return json;
}

Result<nlohmann::json> read_json(std::string_view text) try {
  if (nests_too_deep(text))
    return Error{"the JSON nests deeper than " + std::to_string(kDeepestJson) + " levels"};
  return nlohmann::json::parse(text);
} catch (const nlohmann::json::parse_error& error) {
  return Error{"no JSON at byte " + std::to_string(error.byte)};
}

std::string json_text(const nlohmann::json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string ordered_json_text(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace galilean
