// SPDX-License-Identifier: BSD-3-Clause
#include "sim/camera/noise.h"

#include <algorithm>
#include <cmath>

namespace galilean::sim {

NoiseTable::NoiseTable(double deviation_levels, Random random) {
  for (auto& level : levels_)
    level = static_cast<std::int8_t>(
        std::clamp(std::lround(random.normal() * deviation_levels), -127L, 127L));
}

void NoiseTable::add(const std::uint8_t* from, std::size_t count, std::uint32_t place,
                     std::uint8_t* to) const noexcept {
  const std::int8_t* noise = &levels_[place % kSize];
  for (std::size_t i = 0; i < count; ++i) {
    const auto sum =
        static_cast<std::int16_t>(from[i] + noise[i]);  // 16 bits, so that it is vectorised
    to[i] = static_cast<std::uint8_t>(std::clamp<std::int16_t>(sum, 0, 255));
  }
}

}  // namespace galilean::sim
