#include "monitor/map/landmarks/things.h"

namespace galilean::monitor {
namespace {

constexpr double kFootprintDeviation_m = 0.12;
constexpr double kPushedWithin_m = 0.42;
constexpr double kPushed_m2ps = 4e-3;

}  // namespace

void Things::put(Thing& thing, const std::string& robot, const Gaussian2& from_robot) {
  const auto placed = place_of(joint_, robots_.part(robot), from_robot);
  joint_.remove(thing.part);
  thing.part = joint_.add(placed.in_map_m, placed.of, placed.noise_m2);
}

void Things::blur_around(const std::string& robot, double for_s) {
  const Vec2 at_m = robots_.pose(robot).position_m;
  for (const auto& thing : things_)
    if (thing.object_class != "obstacle" &&
        (joint_.position(thing.part) - at_m).norm() < kPushedWithin_m)
      joint_.blur(thing.part, kPushed_m2ps * for_s * Mat2::Identity());
}

void Things::clear_under(const std::string& robot) {
  const auto part = robots_.part(robot);
  const Vec2 robot_m = joint_.position(part);
  std::vector<std::uint64_t> under;
  for (const auto& thing : things_) {
    if (thing.object_class != "trash") continue;
    if ((joint_.position(thing.part) - robot_m).norm() > kFootprint_m) continue;
    const auto expected = expected_sighting(joint_, part, thing.part);
    const Fit fit = fit_of(joint_, expected, {expected.from_robot_m, Mat2::Identity()});
    if (fit.deviation_m < kFootprintDeviation_m) under.push_back(thing.id);
  }
  for (const auto id : under) forget(id);
}

void Things::clear_under(const Gaussian2& robot) {
  std::vector<std::uint64_t> under;
  for (const auto& thing : things_) {
    if (thing.object_class != "trash") continue;
    if ((joint_.position(thing.part) - robot.mean_m).norm() > kFootprint_m) continue;
    const double variance_m2 = (joint_.covariance(thing.part) + robot.covariance_m2).trace();
    if (variance_m2 < 2 * kFootprintDeviation_m * kFootprintDeviation_m) under.push_back(thing.id);
  }
  for (const auto id : under) forget(id);
}

}  // namespace galilean::monitor
