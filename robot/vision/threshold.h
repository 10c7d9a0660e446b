// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace galilean::robot {

enum class Polarity : std::uint8_t { kBright, kDark };

/// Which pixels stand out.
struct Threshold {
  std::uint8_t level = 0;
  Polarity polarity = Polarity::kBright;  ///< bright: pixel >= level; dark: pixel < level
};

/// Bit i % 8 of byte i / 8 of `mask` tells whether pixel i stands out. `mask` has room for
/// `mask_bytes(pixels.size())`; what lies behind the last pixel's bit is undefined.
void threshold_mask(std::span<const std::uint8_t> pixels, Threshold threshold,
                    std::uint8_t* mask) noexcept;

/// Vectors may be written whole, beyond the last pixel.
[[nodiscard]] constexpr std::size_t mask_bytes(std::size_t pixels) noexcept {
  return (pixels + 7) / 8 + 8;
}

}  // namespace galilean::robot
