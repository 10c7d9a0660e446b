// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <span>
#include <string>

namespace galilean::wire {

[[nodiscard]] inline std::string hexadecimal(std::span<const std::uint8_t> bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}
[[nodiscard]] inline std::string hexadecimal(const dds_guid_t& guid) {
  return hexadecimal(guid.v);
}

/// Returns the name that an entity announced, or an empty text if it announced none.
[[nodiscard]] inline std::string announced_name(const dds_qos_t* qos) {
  char* name = nullptr;
  if (!dds_qget_entity_name(qos, &name) || !name) return {};
  std::string copy = name;
  dds_free(name);
  return copy;
}

}  // namespace galilean::wire
