#include "monitor/map/relocalization/bearings_fit.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/estimation/gaussian.h"

namespace galilean::monitor {
namespace {

constexpr double kStep_rad = 0.025;
constexpr double kRangeError_m = 0.10, kRangeErrorShare = 0.10;
constexpr double kSideError_m = 0.10, kSideErrorShare = 0.04;
constexpr double kFarthest = 3;  ///< in the measure of the errors
constexpr double kAgrees = 0.3;  ///< of 1
constexpr double kBearingsLead = 0.9;
constexpr double kSamePeak_rad = 0.15;
constexpr double kLeastAgreeingShare = 0.6;
/// Two may agree by chance on any of many turns.
constexpr double kNarrow_rad = 0.5;

struct Candidate {
  double turn_rad = 0;
  double score = 0;
  std::size_t agreeing = 0;
  double nearest = 0;  ///< squared distance of the mark that is tried
};
using Candidates = std::vector<Candidate>;

Candidates candidates_within(double most_rad, double deviation_rad) {
  Candidates candidates;
  for (int i = -static_cast<int>(most_rad / kStep_rad); i * kStep_rad <= most_rad; ++i) {
    const double deviations = i * kStep_rad / deviation_rad;
    candidates.push_back({i * kStep_rad, -0.5 * std::min(1.0, deviations * deviations)});
  }
  return candidates;
}

/// Lays `seen`, whose errors are so large, beside a landmark that is known, by every turn that
/// brings it near: both are from the robot, x forward, y left.
struct Laid {
  double range_m, azimuth_rad, range_error_m, side_error_m;

  explicit Laid(const Vec2& seen_m)
      : range_m(seen_m.norm()),
        azimuth_rad(std::atan2(seen_m.y(), seen_m.x())),
        range_error_m(kRangeError_m + kRangeErrorShare * range_m),
        side_error_m(kSideError_m + kSideErrorShare * range_m) {}

  void beside(const Vec2& known_m, Candidates& candidates) const {
    const double known_range_m = known_m.norm();
    if (std::abs(known_range_m - range_m) > kFarthest * (range_error_m + side_error_m)) return;
    const double widest = kFarthest * side_error_m / known_range_m;
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

/// Adds how well the nearest landmark of its kind fits, 0 to 1.
void add_fit(const Mark& seen, const std::vector<Mark>& known, Candidates& candidates) {
  const Laid laid(seen.in_map_m);
  for (auto& each : candidates) each.nearest = kFarthest * kFarthest;
  for (const Mark& mark : known)
    if (mark.kind == seen.kind) laid.beside(mark.in_map_m, candidates);
  for (auto& each : candidates) {
    const double fit = each.nearest < kFarthest * kFarthest ? std::exp(-each.nearest / 2) : 0;
    each.score += fit;
    each.agreeing += fit > kAgrees ? 1 : 0;
  }
}

}  // namespace

std::optional<double> BearingsFit::turn(const std::vector<Mark>& seen,
                                        const std::vector<Mark>& known, const Pose2& pose,
                                        double deviation_rad, double most_rad) {
  if (seen.empty() || known.empty()) return std::nullopt;
  auto candidates = candidates_within(most_rad, deviation_rad);
  const Mat2 turn = rotation_by(-pose.heading_rad);
  std::vector<Mark> from_robot = known;
  for (Mark& mark : from_robot) mark.in_map_m = turn * (mark.in_map_m - pose.position_m);
  for (const Mark& mark : seen) add_fit(mark, from_robot, candidates);
  const Candidate best = *std::ranges::max_element(candidates, {}, &Candidate::score);
  const std::size_t least = most_rad < kNarrow_rad ? 2 : 3;
  if (best.agreeing < least ||
      static_cast<double>(best.agreeing) < kLeastAgreeingShare * static_cast<double>(seen.size()))
    return std::nullopt;
  const bool rivalled = std::ranges::any_of(candidates, [&](const Candidate& other) {
    return std::abs(other.turn_rad - best.turn_rad) > kSamePeak_rad &&
           other.score > best.score - kBearingsLead;
  });
  return rivalled ? std::nullopt : std::optional(best.turn_rad);
}

}  // namespace galilean::monitor
