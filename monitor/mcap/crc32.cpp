// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/crc32.h"

#include <zlib.h>

namespace galilean::mcap {

std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t so_far) noexcept {
  // An empty span may have a null pointer. zlib would return its initial value then, not `so_far`.
  if (bytes.empty()) return so_far;
  return static_cast<std::uint32_t>(::crc32_z(so_far, bytes.data(), bytes.size()));
}

}  // namespace galilean::mcap
