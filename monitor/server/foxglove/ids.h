// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

namespace galilean::monitor::foxglove {

/// Returns the id that a client gave; nothing if it is none. The largest number is no id.
[[nodiscard]] inline std::optional<std::uint32_t> id_of(const nlohmann::json& json) {
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > 0xfffffffe) return std::nullopt;
  return json.get<std::uint32_t>();
}

/// Returns the id that is the member `key` of `object`.
[[nodiscard]] inline std::optional<std::uint32_t> id_of(const nlohmann::json& object,
                                                        const char* key) {
  if (!object.is_object() || !object.contains(key)) return std::nullopt;
  return id_of(object[key]);
}

}  // namespace galilean::monitor::foxglove
