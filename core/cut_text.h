// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace galilean {

/// Returns as much of the beginning of a UTF-8 text as fits into `most_bytes` and ends with a whole
/// character. Every text that must be short is cut by this function: half a character makes a
/// message, or a file of JSON, that others cannot read. Bytes that are no UTF-8 are cut anywhere.
[[nodiscard]] constexpr std::string_view cut_text(std::string_view text,
                                                  std::size_t most_bytes) noexcept {
  constexpr std::size_t kMostContinuing = 3;
  if (text.size() <= most_bytes) return text;
  for (std::size_t back = 0; back <= kMostContinuing && back <= most_bytes; ++back) {
    const std::size_t end = most_bytes - back;
    const bool continues = (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U;
    if (!continues) return text.substr(0, end);
  }
  return text.substr(0, most_bytes);
}

}  // namespace galilean
