#pragma once

#include <nlohmann/json.hpp>

namespace galilean::monitor::foxglove {

/// A request's list; empty where there is none.
[[nodiscard]] inline const nlohmann::json& list_of(const nlohmann::json& request, const char* key) {
  static const nlohmann::json kNone = nlohmann::json::array();
  return request.contains(key) && request[key].is_array() ? request[key] : kNone;
}

}  // namespace galilean::monitor::foxglove
