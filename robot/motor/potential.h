// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::robot {

/// Returns a repulsion without unit: `limit` if d <= min; limit · (max - d) / (max - min) if d <
/// max; else 0. All distances in metres.
[[nodiscard]] constexpr double linear_repulsion(double distance_m, double min_m, double max_m,
                                                double limit) noexcept {
  if (distance_m <= min_m) return limit;
  if (distance_m >= max_m) return 0;
  return limit * (max_m - distance_m) / (max_m - min_m);
}

}  // namespace galilean::robot
