// SPDX-License-Identifier: BSD-3-Clause
#include "core/json_text.h"

#include <optional>

namespace galilean {
namespace {

/// Returns what of `limits` or of kDeepestJson the text exceeds, as a clause behind "JSON"; nothing
/// if it exceeds none. The depth is exact where the text is JSON, and an empty container counts as
/// two values at most. It is found before parsing and without recursion, because the parser would
/// build a value for every bracket of a hostile text.
std::optional<std::string> excess_of(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.bytes) return "has more than " + std::to_string(limits.bytes) + " bytes";
  int depth = 0;
  std::size_t values = 1;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char at = text[i];
    if (at == '"')
      in_string = !in_string;
    else if (in_string && at == '\\')
      ++i;
    else if (in_string)
      continue;
    else if (at == '[' || at == '{')
      ++depth, ++values;
    else if (at == ']' || at == '}')
      --depth;
    else if (at == ',')
      ++values;
    if (depth > kDeepestJson)
      return "nests deeper than " + std::to_string(kDeepestJson) + " levels";
    if (values > limits.values)
      return "holds more than " + std::to_string(limits.values) + " values";
  }
  return std::nullopt;
}

}  // namespace

Result<nlohmann::json> read_untrusted_json(std::string_view text, const JsonLimits& limits) {
  if (const auto excess = excess_of(text, limits)) return Error{"This JSON " + *excess + "."};
  auto json = nlohmann::json::parse(text, nullptr, false);
  if (json.is_discarded()) return Error{"This is not JSON in UTF-8."};
  return json;
}

Result<nlohmann::json> read_json(std::string_view text) try {
  if (const auto excess = excess_of(text, {})) return Error{"the JSON " + *excess};
  return nlohmann::json::parse(text);
} catch (const nlohmann::json::parse_error& error) {
  return Error{"no JSON at byte " + std::to_string(error.byte)};
} catch (const nlohmann::json::out_of_range&) {
  return Error{"the JSON holds a number that is too large"};
}

std::string json_text(const nlohmann::json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string ordered_json_text(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace galilean
