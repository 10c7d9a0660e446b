// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/basket_recognition.h"

#include <algorithm>
#include <limits>

#include "monitor/map/estimation/motion_model.h"

namespace galilean::monitor {
namespace {

constexpr double kReliableRange_m = 3;  ///< the position of a basket further away is not reliable
constexpr double kRelocalized_rad = 0.3;

}  // namespace

void BasketRecognition::recognize(const std::string& robot,
                                  std::vector<Observation>& observations) {
  bool strange = false;
  for (auto& each : observations) {
    if (each.landmark || !each.measurement.complete || each.sighting->object_class != "basket")
      continue;
    const auto known = basket_beside(each, robot);
    const bool seen_as_two =
        known &&
        std::ranges::find(observations, known, &Observation::landmark) != observations.end();
    if (!known || seen_as_two) continue;
    each.landmark = known;
    if (each.measurement.in_robot.mean_m.norm() > kReliableRange_m) continue;
    strange = true;
    if (strange_frames_[robot] + 1 >= kStrangeFrames)
      relocalize(robot, landmarks_.all()[*known], each.measurement);
  }
  int& frames = strange_frames_[robot];
  frames = strange && frames + 1 < kStrangeFrames ? frames + 1 : 0;
}

std::optional<std::size_t> BasketRecognition::basket_beside(const Observation& basket,
                                                            const std::string& robot) const {
  const auto block = robots_.block(robot);
  const auto& landmarks = landmarks_.all();
  const Vec2 at_m = inverse_measurement(joint_, block, basket.measurement.in_robot).in_map_m;
  std::optional<std::size_t> nearest;
  double nearest_m = std::numeric_limits<double>::infinity(), next_m = nearest_m;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (landmarks[i].object_class != "basket" || !landmarks[i].is_confirmed()) continue;
    const double apart_m = (joint_.position(landmarks[i].block) - at_m).norm();
    next_m = std::min(next_m, std::max(apart_m, nearest_m));
    if (apart_m >= nearest_m) continue;
    nearest = i;
    nearest_m = apart_m;
  }
  if (!nearest || nearest_m < kBasketsApart_m) return nearest;
  const auto predicted = predict_measurement(joint_, block, landmarks[*nearest].block);
  const double deviation_m =
      compatibility_of(joint_, predicted, basket.measurement.in_robot).deviation_m;
  const bool lost = nearest_m < deviation_m && next_m > nearest_m + kBasketsApart_m;
  return lost ? nearest : std::nullopt;
}

// The filter would correct only a part of an innovation that is much larger than its uncertainty.
// Therefore the robot's pose is made uncertain first.
void BasketRecognition::relocalize(const std::string& robot, const Landmark& basket,
                                   const Measurement& measurement) {
  const auto block = robots_.block(robot);
  const auto predicted = predict_measurement(joint_, block, basket.block);
  const double apart_m = (predicted.in_robot_m - measurement.in_robot.mean_m).norm();
  RobotMatrix noise = RobotMatrix::Zero();
  noise.diagonal().head<3>() << apart_m * apart_m, apart_m * apart_m,
      kRelocalized_rad * kRelocalized_rad;
  joint_.inflate(block, noise);
  correct_by(joint_, predicted, measurement.in_robot);
}

}  // namespace galilean::monitor
