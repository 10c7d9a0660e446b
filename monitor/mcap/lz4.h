// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace galilean::mcap {

/// Decompresses an LZ4 frame. Returns false if it is damaged or does not fill `to` exactly.
[[nodiscard]] bool decompress_lz4(std::span<const std::uint8_t> frame, std::span<std::uint8_t> to);

/// Replaces `frame` by `bytes` as one LZ4 frame.
void compress_lz4(std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& frame);

}  // namespace galilean::mcap
