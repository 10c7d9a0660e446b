#include <algorithm>
#include <limits>

#include "monitor/map/estimation/robot_motion.h"
#include "monitor/map/landmarks/landmark_map.h"

namespace galilean::monitor {
namespace {

constexpr double kBasketsApart_m = 1.2;  ///< nearer to one another no two stand
constexpr double kPlainBasket_m = 3;     ///< further away, its place is not to be relied upon
constexpr int kStrangeFrames = 5;
constexpr double kRelocated_rad = 0.3;

}  // namespace

void LandmarkMap::recognise_baskets(const std::string& robot, std::vector<Seen>& seen) {
  bool strange = false;
  for (auto& each : seen) {
    if (each.landmark || !each.bearing.whole || each.sighting->object_class != "basket") continue;
    const auto known = basket_beside(each, robot);
    const bool seen_as_two = known && std::ranges::find(seen, known, &Seen::landmark) != seen.end();
    if (!known || seen_as_two) continue;
    each.landmark = known;
    if (each.bearing.from_robot.mean_m.norm() > kPlainBasket_m) continue;
    strange = true;
    if (strange_frames_[robot] + 1 >= kStrangeFrames)
      relocate(robot, landmarks_[*known], each.bearing);
  }
  int& frames = strange_frames_[robot];
  frames = strange && frames + 1 < kStrangeFrames ? frames + 1 : 0;
}

std::optional<std::size_t> LandmarkMap::basket_beside(const Seen& basket,
                                                      const std::string& robot) const {
  const auto part = robots_.part(robot);
  const Vec2 at_m = place_of(joint_, part, basket.bearing.from_robot).in_map_m;
  std::optional<std::size_t> nearest;
  double nearest_m = std::numeric_limits<double>::infinity(), next_m = nearest_m;
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    if (landmarks_[i].object_class != "basket" || !landmarks_[i].is_confirmed()) continue;
    const double apart_m = (joint_.position(landmarks_[i].part) - at_m).norm();
    next_m = std::min(next_m, std::max(apart_m, nearest_m));
    if (apart_m >= nearest_m) continue;
    nearest = i;
    nearest_m = apart_m;
  }
  if (!nearest || nearest_m < kBasketsApart_m) return nearest;
  // A robot that lost its way, and knows it, may be further off; then no other may come near.
  const auto expected = expected_sighting(joint_, part, landmarks_[*nearest].part);
  const double deviation_m = fit_of(joint_, expected, basket.bearing.from_robot).deviation_m;
  const bool lost = nearest_m < deviation_m && next_m > nearest_m + kBasketsApart_m;
  return lost ? nearest : std::nullopt;
}

/// The filter would not believe it: first it must learn that the robot may be anywhere near.
void LandmarkMap::relocate(const std::string& robot, const Landmark& basket,
                           const Bearing& bearing) {
  const auto part = robots_.part(robot);
  const auto expected = expected_sighting(joint_, part, basket.part);
  const double apart_m = (expected.from_robot_m - bearing.from_robot.mean_m).norm();
  RobotMatrix unsure = RobotMatrix::Zero();
  unsure.diagonal().head<3>() << apart_m * apart_m, apart_m * apart_m,
      kRelocated_rad * kRelocated_rad;
  joint_.blur(part, unsure);
  correct(basket, bearing, part);
}

}  // namespace galilean::monitor
