// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/random.h"

namespace galilean::sim {

/// A sensor's noise, drawn once. To add it costs one look-up a byte.
class NoiseTable {
 public:
  static constexpr std::uint32_t kSize = 1 << 13;

  /// `deviation_levels`: standard deviation in steps of 0 … 255.
  NoiseTable(double deviation_levels, Random random);

  [[nodiscard]] int at(std::uint32_t place) const noexcept { return levels_[place % kSize]; }
  /// Writes `from` with noise to `count` bytes, at most `kLongest`.
  void add(const std::uint8_t* from, std::size_t count, std::uint32_t place,
           std::uint8_t* to) const noexcept;

  static constexpr std::uint32_t kLongest = 2048;

 private:
  std::array<std::int8_t, kSize + kLongest> levels_;
};

[[nodiscard]] inline std::uint8_t to_level(int value) noexcept {
  return static_cast<std::uint8_t>(value < 0 ? 0 : value > 255 ? 255 : value);
}

}  // namespace galilean::sim
