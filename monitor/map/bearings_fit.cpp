#include "monitor/map/bearings_fit.h"

#include <algorithm>
#include <cmath>

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

/// How well the nearest thing of its kind fits, 0 to 1.
double fit_of(const Mark& seen, const std::vector<Mark>& known, const Pose2& pose) {
  const double range_m = seen.in_map_m.norm();
  const double range_error_m = kRangeError_m + kRangeErrorShare * range_m;
  const double side_error_m = kSideError_m + kSideErrorShare * range_m;
  const Vec2 along = rotated(seen.in_map_m / range_m, pose.heading_rad);
  const Vec2 there_m = pose.position_m + range_m * along;
  double nearest = kFarthest * kFarthest;
  for (const Mark& mark : known) {
    if (mark.kind != seen.kind) continue;
    const Vec2 apart_m = mark.in_map_m - there_m;
    const double radial = apart_m.dot(along) / range_error_m;
    const double lateral = (along.x() * apart_m.y() - along.y() * apart_m.x()) / side_error_m;
    nearest = std::min(nearest, radial * radial + lateral * lateral);
  }
  return nearest < kFarthest * kFarthest ? std::exp(-nearest / 2) : 0;
}

struct Candidate {
  double turn_rad = 0;
  double score = 0;
  std::size_t agreeing = 0;
};

Candidate candidate_at(double turn_rad, const std::vector<Mark>& seen,
                       const std::vector<Mark>& known, const Pose2& pose, double deviation_rad) {
  const Pose2 turned{pose.position_m, pose.heading_rad + turn_rad};
  const double deviations = turn_rad / deviation_rad;
  Candidate candidate{turn_rad, -0.5 * std::min(1.0, deviations * deviations), 0};
  for (const Mark& mark : seen) {
    const double fit = fit_of(mark, known, turned);
    candidate.score += fit;
    candidate.agreeing += fit > kAgrees ? 1 : 0;
  }
  return candidate;
}

}  // namespace

std::optional<double> BearingsFit::turn(const std::vector<Mark>& seen,
                                        const std::vector<Mark>& known, const Pose2& pose,
                                        double deviation_rad, double most_rad) {
  std::vector<Candidate> candidates;
  for (int i = -static_cast<int>(most_rad / kStep_rad); i * kStep_rad <= most_rad; ++i)
    candidates.push_back(candidate_at(i * kStep_rad, seen, known, pose, deviation_rad));
  if (candidates.empty()) return std::nullopt;
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
