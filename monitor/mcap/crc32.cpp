// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/crc32.h"

#include <libdeflate.h>

namespace galilean::mcap {

std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t so_far) noexcept {
  // An empty span may have a null pointer, for which the library returns its initial value.
  if (bytes.empty()) return so_far;
  return ::libdeflate_crc32(so_far, bytes.data(), bytes.size());
}

}  // namespace galilean::mcap
