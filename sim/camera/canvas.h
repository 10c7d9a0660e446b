// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "core/device/frame.h"
#include "sim/camera/noise.h"
#include "sim/camera/scene.h"
#include "sim/camera/view.h"

namespace galilean::sim {

/// The data that all painters of one picture share.
struct Canvas {
  static constexpr int kWidth = Frame::kWidth;
  static constexpr int kHeight = Frame::kHeight;

  Frame& frame;
  const View& view;
  const NoiseTable& noise;
  std::uint32_t noise_place;  ///< where this picture begins in the noise table
  /// 1/depth [1/m] of the furniture in each column. It hides what stands behind it.
  std::array<float, kWidth> furniture{};

  [[nodiscard]] std::uint8_t* pixel(int column, int row) noexcept {
    return frame.rgb.data() + (row * kWidth + column) * 3;
  }
  [[nodiscard]] bool hidden(int column, float inverse_depth) const noexcept {
    return furniture[static_cast<std::size_t>(column)] > inverse_depth;
  }
  void put(int column, int row, Colour colour, float light) noexcept {
    std::uint8_t* at = pixel(column, row);
    const auto place = noise_place + static_cast<std::uint32_t>(column * 61 + row * 1217);
    const int grain = noise.at(place);
    at[0] = to_level(static_cast<int>(colour.red * light) + grain);
    at[1] = to_level(static_cast<int>(colour.green * light) + noise.at(place + 1));
    at[2] = to_level(static_cast<int>(colour.blue * light) + noise.at(place + 2));
  }
};

/// Returns the first pixel whose centre lies at or after `edge`, inside 0 … limit.
[[nodiscard]] inline int first_pixel(float edge, int limit) noexcept {
  if (!(edge > 0)) return 0;
  if (edge >= static_cast<float>(limit)) return limit;
  const int pixel = static_cast<int>(edge + 0.5f);  // NOLINT(bugprone-incorrect-roundings): > 0
  return pixel < limit ? pixel : limit;
}

}  // namespace galilean::sim
