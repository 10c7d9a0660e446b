#include "monitor/map/carried.h"

#include <algorithm>

namespace galilean::monitor {
namespace {

constexpr double kGripperAhead_m = 0.27;
constexpr double kReach_m = 0.25;  ///< from the gripper to what it may have picked up
constexpr double kCarriedWithin_m = 0.25;
constexpr double kBasketReach_m = 0.65;  ///< what is put down nearer than this is in the basket
constexpr double kInGripper_m = 0.03;

const Gaussian2 kInGripper{{kGripperAhead_m, 0}, kInGripper_m* kInGripper_m* Mat2::Identity()};

}  // namespace

Gaussian2 Carried::place(const std::string& robot, const RobotPoses& robots) {
  const Pose2 pose = robots.pose(robot);
  const Gaussian2 at = robots.position(robot);
  return {at.mean_m + kGripperAhead_m * unit_vector(pose.heading_rad),
          at.covariance_m2 + kInGripper.covariance_m2};
}

void Carried::note(const std::string& robot, bool holds, const RobotPoses& robots, Things& things,
                   Time now) {
  const bool held = loads_.contains(robot);
  if (holds && !held) pick_up(robot, robots, things);
  if (!holds && held) put_down(robot, robots, things, now);
}

void Carried::pick_up(const std::string& robot, const RobotPoses& robots, Things& things) {
  const Vec2 gripper_m = place(robot, robots).mean_m;
  const auto distance_m = [&](const Thing& thing) {
    return thing.object_class == "trash" ? (things.place(thing).mean_m - gripper_m).norm()
                                         : 2 * kReach_m;
  };
  Load& load = loads_[robot];
  load.seen_by = {robot};
  const auto nearest = std::ranges::min_element(things.all(), {}, distance_m);
  if (nearest == things.all().end() || distance_m(*nearest) > kReach_m) {
    load.id = things.next_id();
    load.was_known = false;
    return;
  }
  load = {nearest->id, nearest->observers(), true};
  things.forget(load.id);
}

void Carried::put_down(const std::string& robot, const RobotPoses& robots, Things& things,
                       Time now) {
  const Load load = loads_.extract(robot).mapped();
  const Vec2 gripper_m = place(robot, robots).mean_m;
  const bool in_basket = std::ranges::any_of(things.all(), [&](const Thing& thing) {
    return thing.object_class == "basket" && thing.told() &&
           (things.place(thing).mean_m - gripper_m).norm() < kBasketReach_m;
  });
  if (!in_basket && load.was_known) things.note("trash", robot, kInGripper, 1, now, load.id);
}

bool Carried::is_carried(const Vec2& in_map_m, const RobotPoses& robots) const {
  return std::ranges::any_of(loads_, [&](const auto& load) {
    return (place(load.first, robots).mean_m - in_map_m).norm() < kCarriedWithin_m;
  });
}

}  // namespace galilean::monitor
