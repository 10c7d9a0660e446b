// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/landmark_contacts.h"

#include "monitor/map/estimation/measurement_model.h"

namespace galilean::monitor {
namespace {

constexpr double kTouchedAgain_m = 0.20;  ///< a contact nearer than this is with a known obstacle
/// The largest standard deviation with which a landmark is known to be under a robot.
constexpr double kMaxContactDeviation_m = 0.12;
constexpr double kPushedWithin_m = 0.42;
constexpr double kPushed_m2ps = 4e-3;

}  // namespace

void LandmarkContacts::add_contact(const std::string& object_class, const std::string& robot,
                                   const Gaussian2& in_robot, double certainty, Time now,
                                   std::uint64_t id) {
  const Vec2 at_m = inverse_measurement(joint_, robots_.block(robot), in_robot).in_map_m;
  if (object_class == "obstacle")
    for (auto& landmark : landmarks_.all())
      if (landmark.object_class == object_class &&
          (joint_.position(landmark.block) - at_m).norm() < kTouchedAgain_m) {
        landmark.observe(robot, now);
        return;
      }
  landmarks_.add(object_class, robot, in_robot, certainty, now, id);
}

void LandmarkContacts::inflate_near(const std::string& robot, double for_s) {
  const Vec2 at_m = robots_.pose(robot).position_m;
  for (const auto& landmark : landmarks_.all())
    if (landmark.object_class != "obstacle" &&
        (joint_.position(landmark.block) - at_m).norm() < kPushedWithin_m)
      joint_.inflate(landmark.block, kPushed_m2ps * for_s * Mat2::Identity());
}

void LandmarkContacts::clear_footprint(const std::string& robot) {
  const auto block = robots_.block(robot);
  const Vec2 robot_m = joint_.position(block);
  landmarks_.remove_if([&](const Landmark& landmark) {
    if (landmark.object_class != "trash") return false;
    if ((joint_.position(landmark.block) - robot_m).norm() > kFootprint_m) return false;
    const auto predicted = predict_measurement(joint_, block, landmark.block);
    return compatibility_of(joint_, predicted, {predicted.in_robot_m, Mat2::Identity()})
               .deviation_m < kMaxContactDeviation_m;
  });
}

void LandmarkContacts::clear_footprint(const Gaussian2& robot) {
  landmarks_.remove_if([&](const Landmark& landmark) {
    if (landmark.object_class != "trash") return false;
    if ((joint_.position(landmark.block) - robot.mean_m).norm() > kFootprint_m) return false;
    const double variance_m2 = (joint_.covariance(landmark.block) + robot.covariance_m2).trace();
    return variance_m2 < 2 * kMaxContactDeviation_m * kMaxContactDeviation_m;
  });
}

}  // namespace galilean::monitor
