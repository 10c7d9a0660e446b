#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace galilean::monitor {

/// JSON text of anything: bytes from outside that are not UTF-8 become U+FFFD.
[[nodiscard]] inline std::string json_text(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace galilean::monitor
