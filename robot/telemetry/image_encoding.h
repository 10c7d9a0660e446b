// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace galilean::robot {

/// Encodes a picture of 352 × 186 pixels, red, green and blue interleaved, as JPEG into `to`.
void encode_jpeg(std::span<const std::uint8_t> rgb, std::vector<std::uint8_t>& to);

/// Encodes a picture of 352 × 186 pixels, one byte each, as PNG into `to`, without loss.
void encode_png(std::span<const std::uint8_t> gray, std::vector<std::uint8_t>& to);

}  // namespace galilean::robot
