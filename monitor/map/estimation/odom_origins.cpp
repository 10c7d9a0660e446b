// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/estimation/odom_origins.h"

namespace galilean::monitor {
namespace {

/// Standard deviations of a pose that a person gave.
constexpr double kPlaced_m = 0.06;
constexpr double kPlaced_rad = 0.15;
/// Standard deviation of the reference robot's pose [m, rad]. The filter cannot take a variance of
/// 0.
constexpr double kReference = 1e-3;
/// Standard deviations of a pose that nobody gave.
constexpr double kGuessed_m = 0.15;
constexpr double kGuessed_rad = 0.2;

}  // namespace

OdomOrigins::Origin OdomOrigins::of(const std::string& robot) const {
  if (const auto given = given_.find(robot); given != given_.end())
    return {given->second, kPlaced_m, kPlaced_rad};
  if (!given_.empty()) return {given_.begin()->second, kGuessed_m, kGuessed_rad};
  if (robot == first_heard_) return {{}, kReference, kReference, true};
  return {{}, kGuessed_m, kGuessed_rad};
}

}  // namespace galilean::monitor
