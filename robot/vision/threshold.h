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

/// Sets bit i % 8 of byte i / 8 of `mask` if pixel i stands out, and clears it otherwise. Requires:
/// `mask` has room for `mask_bytes(pixels.size())`. Bits behind the last pixel's are undefined.
void threshold_mask(std::span<const std::uint8_t> pixels, Threshold threshold,
                    std::uint8_t* mask) noexcept;

/// Returns the bytes of a mask. They include room for whole vectors beyond the last pixel.
[[nodiscard]] constexpr std::size_t mask_bytes(std::size_t pixels) noexcept {
  return (pixels + 7) / 8 + 8;
}

}  // namespace galilean::robot
