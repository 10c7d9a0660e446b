// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace galilean::robot {

/// Where to write each component of a picture, one byte a pixel. A null plane is not written.
struct ComponentPlanes {
  std::uint8_t* superred = nullptr;
  std::uint8_t* supergreen = nullptr;
  std::uint8_t* superblue = nullptr;
  std::uint8_t* intensity = nullptr;
};

/// A factor for all channels, in 1/256: a byte x becomes min(255, x · gain / 256).
using Gain = std::uint16_t;
inline constexpr Gain kUnityGain = 256;

/// Normalised RGB: the gain that brings the picture's white point, the 98th percentile of
/// max(R, G, B) over every eighth pixel of every eighth row, to 240; from 1 to 2. One threshold
/// then holds in a bright hall and in a dim one. All channels share it, so that hues stay.
[[nodiscard]] Gain normalising_gain(std::span<const std::uint8_t> rgb, int width_px) noexcept;

/// Splits interleaved RGB, once over the picture, in the widest vectors that the machine has:
///   superred = max(0, R - (G + B)), supergreen and superblue alike; intensity = (R + 2G + B) / 4,
///   rounded up by less than 1; all times the gain. Each plane holds rgb.size() / 3 bytes,
/// which must be 256 or more.
void split_components(std::span<const std::uint8_t> rgb, Gain gain,
                      const ComponentPlanes& planes) noexcept;

}  // namespace galilean::robot
