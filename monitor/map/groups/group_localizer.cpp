// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/groups/group_localizer.h"

#include <algorithm>

#include "monitor/map/relocalization/transform_blocks.h"

namespace galilean::monitor {
namespace {

/// The standard deviation of a point. It is small because all pairs of a class are tried, and of
/// two dozen landmarks in a room some agree by chance.
constexpr double kDeviation_m = 0.06;
constexpr double kLeastGroupSpread_m = 0.8;
/// Limits of the cost, which grows fast because every two correspondences are compared with all
/// others.
constexpr std::size_t kMaxOwn = 24, kMaxKnown = 48;

std::vector<LabelledPoint> own_points(const RobotGroup& group) {
  std::vector<LabelledPoint> points;
  for (const auto& landmark : group.landmarks.all())
    if (landmark.is_confirmed() && landmark.object_class != "obstacle" && points.size() < kMaxOwn)
      points.push_back(
          {group.joint.position(landmark.block), label_of(landmark.object_class), landmark.id});
  return points;
}

/// Returns the others' landmarks. Of more than kMaxKnown, it returns those that are nearest to the
/// group's estimated place.
std::vector<LabelledPoint> points_of_others(const RobotGroup& group,
                                            const PublishedLandmarks& published) {
  auto points = known_to_others(group, published);
  const Vec2 centre_m = group.extent_m.center();
  std::ranges::stable_sort(points, {}, [&](const LabelledPoint& point) {
    return (point.position_m - centre_m).squaredNorm();
  });
  points.resize(std::min(points.size(), kMaxKnown));
  return points;
}

std::vector<Correspondence> all_correspondences(const RobotGroup& group,
                                                const PublishedLandmarks& published) {
  const auto known = points_of_others(group, published);
  std::vector<Correspondence> correspondences;
  for (const LabelledPoint& own : own_points(group))
    for (const LabelledPoint& other : known)
      if (own.label == other.label)
        correspondences.push_back({other.position_m, own.position_m, other.id, own.id});
  return correspondences;
}

std::vector<JointGaussian::Block> blocks_of(const RobotGroup& group) {
  std::vector<JointGaussian::Block> blocks;
  for (const auto& [name, robot] : group.poses.all()) blocks.push_back(robot.block);
  for (const auto& landmark : group.landmarks.all()) blocks.push_back(landmark.block);
  return blocks;
}

}  // namespace

void GroupLocalizer::localize_next(const PublishedLandmarks& published) {
  RobotGroup& group = *groups_.all()[next_++ % groups_.all().size()];
  if (!group.is_localized) localize(group, published);
}

void GroupLocalizer::localize(RobotGroup& group, const PublishedLandmarks& published) {
  const auto fit =
      fit_rigid_transform(all_correspondences(group, published), kDeviation_m, kLeastAgreeing);
  const auto before = candidates_.find(&group);
  const bool again = before != candidates_.end() && are_similar(before->second, fit);
  candidates_.erase(&group);
  if (fit.agreeing.empty() || fit.spread_m < kLeastGroupSpread_m) return;
  if (!again) {
    candidates_[&group] = fit;
    return;
  }
  transform_blocks(group.joint, blocks_of(group), fit);
  group.is_localized = true;
}

}  // namespace galilean::monitor
