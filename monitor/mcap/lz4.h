// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace galilean::mcap {

/// Decompresses an LZ4 frame. Returns false if it is damaged or does not fill `to` exactly.
[[nodiscard]] bool decompress_lz4(std::span<const std::uint8_t> frame, std::span<std::uint8_t> to);

}  // namespace galilean::mcap
