#include "monitor/map/landmarks/landmark_map.h"

namespace galilean::monitor {
namespace {

constexpr double kFootprintDeviation_m = 0.12;
constexpr double kPushedWithin_m = 0.42;
constexpr double kPushed_m2ps = 4e-3;

}  // namespace

void LandmarkMap::replace(Landmark& landmark, const std::string& robot,
                          const Gaussian2& from_robot) {
  const auto placed = place_of(joint_, robots_.part(robot), from_robot);
  joint_.remove(landmark.part);
  landmark.part = joint_.add(placed.in_map_m, placed.of, placed.noise_m2);
}

void LandmarkMap::inflate_near(const std::string& robot, double for_s) {
  const Vec2 at_m = robots_.pose(robot).position_m;
  for (const auto& landmark : landmarks_)
    if (landmark.object_class != "obstacle" &&
        (joint_.position(landmark.part) - at_m).norm() < kPushedWithin_m)
      joint_.blur(landmark.part, kPushed_m2ps * for_s * Mat2::Identity());
}

void LandmarkMap::clear_footprint(const std::string& robot) {
  const auto part = robots_.part(robot);
  const Vec2 robot_m = joint_.position(part);
  std::vector<std::uint64_t> under;
  for (const auto& landmark : landmarks_) {
    if (landmark.object_class != "trash") continue;
    if ((joint_.position(landmark.part) - robot_m).norm() > kFootprint_m) continue;
    const auto expected = expected_sighting(joint_, part, landmark.part);
    const Fit fit = fit_of(joint_, expected, {expected.from_robot_m, Mat2::Identity()});
    if (fit.deviation_m < kFootprintDeviation_m) under.push_back(landmark.id);
  }
  for (const auto id : under) remove(id);
}

void LandmarkMap::clear_footprint(const Gaussian2& robot) {
  std::vector<std::uint64_t> under;
  for (const auto& landmark : landmarks_) {
    if (landmark.object_class != "trash") continue;
    if ((joint_.position(landmark.part) - robot.mean_m).norm() > kFootprint_m) continue;
    const double variance_m2 = (joint_.covariance(landmark.part) + robot.covariance_m2).trace();
    if (variance_m2 < 2 * kFootprintDeviation_m * kFootprintDeviation_m)
      under.push_back(landmark.id);
  }
  for (const auto id : under) remove(id);
}

}  // namespace galilean::monitor
