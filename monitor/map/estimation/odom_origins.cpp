// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/estimation/odom_origins.h"

namespace galilean::monitor {
namespace {

/// How well a person places a robot, or says where it is (standard deviations).
constexpr double kPlaced_m = 0.06;
constexpr double kPlaced_rad = 0.15;
/// How well the pose of the reference is known: a filter cannot take a variance of 0.
constexpr double kReference = 1e-3;
/// How well the pose of a robot is known of which nobody said anything.
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
