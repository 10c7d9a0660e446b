// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/touch_evidence.h"

#include <cmath>

namespace galilean::monitor {
namespace {

/// An odometer that counts less than this between two reports stands still.
constexpr double kMoved_m = 0.002;
constexpr double kMoved_rad = 0.01;

}  // namespace

void TouchEvidence::note_pose(const std::string& robot, const Pose2& in_odom, Time now) {
  Robot& moving = robots_[robot];
  const Pose2 before = moving.in_odom.value_or(in_odom);
  moving.in_odom = in_odom;
  if ((in_odom.position_m - before.position_m).norm() > kMoved_m ||
      std::abs(wrap_angle(in_odom.heading_rad - before.heading_rad)) > kMoved_rad)
    moving.moved = now;
}

bool TouchEvidence::is_new(const std::string& robot, const std::string& variable,
                           const Vec2& in_odom_m, Time now) {
  Robot& touching = robots_[robot];
  Touch& touch = touching.touches[variable];
  if (!touch.reported || now - *touch.reported > kReleased)
    touch = {.came_to_robot = !touching.moved || now - *touching.moved > kStill};
  touch.reported = now;
  if (touch.came_to_robot || (in_odom_m - touch.counted_m).norm() < kStep_m) return false;
  touch.counted_m = in_odom_m;
  return true;
}

}  // namespace galilean::monitor
