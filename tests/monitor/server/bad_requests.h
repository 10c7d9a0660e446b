// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace galilean::monitor {

/// Returns valid JSON that nests so deep that code which copies or prints it recurses too far.
inline std::string deep_json(std::size_t levels = 200'000) {
  return std::string(levels, '[') + std::string(levels, ']');
}

/// Returns bodies that the API must refuse: every kind of JSON but an object, a text that is not
/// JSON, and an object that nests too deep.
inline std::vector<std::string> bodies_that_are_no_objects() {
  return {"[]",
          "\"x\"",
          "3",
          "0.5",
          "1e999",
          "null",
          "true",
          "[{}]",
          "{",
          "{]",
          "not JSON",
          std::string("\0", 1),
          "\"\xff\xfe\"",
          "{\"author\": \"\xff\"}",
          "\xef\xbb\xbf[]",
          deep_json(),
          "{\"author\": " + deep_json() + "}",
          "{\"x\": " + deep_json() + "}"};
}

/// Returns values of all types that `schema` does not allow. It is a JSON Schema; where it allows a
/// boolean, an object is allowed, too.
inline std::vector<nlohmann::json> values_that_are_no(const nlohmann::json& schema) {
  using nlohmann::json;
  const std::string type = schema["type"];
  std::vector<json> wrong{nullptr};
  if (type != "boolean") wrong.push_back(true);
  if (type != "string") wrong.push_back("x");
  if (type != "integer" && type != "number") wrong.push_back(3);
  if (type != "number") wrong.push_back(0.5);
  if (type == "integer") wrong.push_back(std::int64_t{1} << 40);
  if (type == "number") wrong.push_back(-1e300);
  if (type != "array") wrong.push_back(json::array());
  if (type == "array")
    for (const json& item :
         {json(3), json(nullptr), json::array(), json{{"path", 3}, {"text", ""}}})
      wrong.push_back(json::array({item}));
  if (type != "boolean") wrong.push_back(json::object());
  return wrong;
}

}  // namespace galilean::monitor
