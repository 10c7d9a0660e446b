// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/relocalization/heading_fit.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/estimation/gaussian.h"

namespace galilean::monitor {
namespace {

constexpr double kStep_rad = 0.025;
constexpr double kRangeError_m = 0.10, kRangeErrorShare = 0.10;
constexpr double kSideError_m = 0.10, kSideErrorShare = 0.04;
/// A point that is further away than so many standard deviations does not count.
constexpr double kMaxDeviations = 3;
/// A point agrees if it counts at least so much, from 0 to 1.
constexpr double kAgrees = 0.3;
constexpr double kLead = 0.9;  ///< the best turn must count more than any other by this
constexpr double kSamePeak_rad = 0.15;
constexpr double kLeastAgreeingShare = 0.6;
/// Two points are enough only if the search is narrower than this, because they may agree by chance
/// on one of many turns.
constexpr double kNarrow_rad = 0.5;

struct Candidate {
  double turn_rad = 0;
  double score = 0;
  std::size_t agreeing = 0;
  double nearest = 0;  ///< squared distance of the known point nearest to the one being added
};
using Candidates = std::vector<Candidate>;

Candidates candidates_within(double max_rad, double deviation_rad) {
  Candidates candidates;
  // A width that is no number leaves the candidate that turns nothing.
  const double width_rad = max_rad >= 0 ? std::min(max_rad, kPi) : 0.0;
  for (int i = -static_cast<int>(width_rad / kStep_rad); i * kStep_rad <= width_rad; ++i) {
    const double deviations = i * kStep_rad / deviation_rad;
    candidates.push_back({i * kStep_rad, -0.5 * std::min(1.0, deviations * deviations)});
  }
  return candidates;
}

/// A seen point and its standard deviations, for comparison with known points. All are in the robot
/// frame (x forward, y left).
struct SeenPoint {
  double range_m, azimuth_rad, range_error_m, side_error_m;

  explicit SeenPoint(const Vec2& seen_m)
      : range_m(seen_m.norm()),
        azimuth_rad(std::atan2(seen_m.y(), seen_m.x())),
        range_error_m(kRangeError_m + kRangeErrorShare * range_m),
        side_error_m(kSideError_m + kSideErrorShare * range_m) {}

  /// Notes the distance from a known point for every turn that brings the two near each other.
  void compare(const Vec2& known_m, Candidates& candidates) const {
    const double known_range_m = known_m.norm();
    if (std::abs(known_range_m - range_m) > kMaxDeviations * (range_error_m + side_error_m)) return;
    const double widest = kMaxDeviations * side_error_m / known_range_m;
    const double window_rad = widest < 1 ? std::asin(widest) : kPi;
    const double off_rad = wrap_angle(std::atan2(known_m.y(), known_m.x()) - azimuth_rad);
    for (auto each =
             std::ranges::lower_bound(candidates, off_rad - window_rad, {}, &Candidate::turn_rad);
         each != candidates.end() && each->turn_rad <= off_rad + window_rad; ++each) {
      const double by_rad = off_rad - each->turn_rad;
      const double radial = (known_range_m * std::cos(by_rad) - range_m) / range_error_m;
      const double lateral = known_range_m * std::sin(by_rad) / side_error_m;
      each->nearest = std::min(each->nearest, radial * radial + lateral * lateral);
    }
  }
};

/// Adds to each candidate how well the nearest known point of the same label fits, from 0 to 1.
void add_fit(const LabelledPoint& seen, const std::vector<LabelledPoint>& known,
             Candidates& candidates) {
  const SeenPoint point_seen(seen.position_m);
  for (auto& each : candidates) each.nearest = kMaxDeviations * kMaxDeviations;
  for (const LabelledPoint& point : known)
    if (point.label == seen.label) point_seen.compare(point.position_m, candidates);
  for (auto& each : candidates) {
    const double fit =
        each.nearest < kMaxDeviations * kMaxDeviations ? std::exp(-each.nearest / 2) : 0;
    each.score += fit;
    each.agreeing += fit > kAgrees ? 1 : 0;
  }
}

}  // namespace

std::optional<double> HeadingFit::find_turn(const std::vector<LabelledPoint>& seen,
                                            const std::vector<LabelledPoint>& known,
                                            const Pose2& pose, double deviation_rad,
                                            double max_rad) {
  if (seen.empty() || known.empty()) return std::nullopt;
  auto candidates = candidates_within(max_rad, deviation_rad);
  const Mat2 turn = rotation_matrix(-pose.heading_rad);
  std::vector<LabelledPoint> in_robot = known;
  for (LabelledPoint& point : in_robot)
    point.position_m = turn * (point.position_m - pose.position_m);
  for (const LabelledPoint& point : seen) add_fit(point, in_robot, candidates);
  const Candidate best = *std::ranges::max_element(candidates, {}, &Candidate::score);
  const std::size_t least = max_rad < kNarrow_rad ? 2 : 3;
  if (best.agreeing < least ||
      static_cast<double>(best.agreeing) < kLeastAgreeingShare * static_cast<double>(seen.size()))
    return std::nullopt;
  const bool rivalled = std::ranges::any_of(candidates, [&](const Candidate& other) {
    return std::abs(other.turn_rad - best.turn_rad) > kSamePeak_rad &&
           other.score > best.score - kLead;
  });
  return rivalled ? std::nullopt : std::optional(best.turn_rad);
}

}  // namespace galilean::monitor
