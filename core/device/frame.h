// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "core/clock.h"

namespace galilean {

/// A colour picture: 8-bit red, green, blue interleaved, row-major from the top left.
struct Frame {
  static constexpr int kWidth = 352;
  static constexpr int kHeight = 186;
  static constexpr int kBytes = kWidth * kHeight * 3;

  std::uint64_t number = 0;  ///< 1, 2, 3 …; 0: none yet
  Time captured{};
  std::array<std::uint8_t, kBytes> rgb{};
};

}  // namespace galilean
