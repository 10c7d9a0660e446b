// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/joint_compatibility.h"

#include <cmath>

namespace galilean::monitor {
namespace {

constexpr double kAgree_m = 0.15, kAgreeShare = 0.05;
constexpr double kLeastApart_m = 0.3;
constexpr double kDeviations = 3;

}  // namespace

bool are_jointly_compatible(const Vec2& seen_m, const Vec2& known_m, double heading_deviation_rad) {
  const double apart_m = seen_m.norm();
  if (apart_m < kLeastApart_m) return false;
  const double allowed_m = kAgree_m + kAgreeShare * apart_m;
  if (std::abs(apart_m - known_m.norm()) > allowed_m) return false;
  const double across = seen_m.x() * known_m.y() - seen_m.y() * known_m.x();
  const double turn_rad = std::abs(std::atan2(across, seen_m.dot(known_m)));
  return turn_rad < kDeviations * heading_deviation_rad + allowed_m / apart_m;
}

}  // namespace galilean::monitor
