#include "monitor/map/relocalization/same_things.h"

#include <gtest/gtest.h>

#include "monitor/map/estimation/robot_motion.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

/// Landmarks of an office, in the map frame; no two pairs are equally far apart.
const std::vector<std::pair<std::string, Vec2>> kLandmarks{
    {"basket", {0.7, 4.2}}, {"basket", {3.6, 3.4}}, {"basket", {4.8, 0.6}}, {"basket", {7.4, 5.2}},
    {"trash", {1.3, 2.1}},  {"trash", {2.9, 1.2}},  {"trash", {5.5, 2.7}},  {"trash", {6.3, 4.4}},
    {"trash", {2.2, 5.1}},  {"trash", {4.1, 4.9}}};

class SameThingsTest : public testing::Test {
 protected:
  /// `robot` stands at `truly`, its odometer at 0, and sees everything.
  void look(const std::string& robot, const Pose2& truly, std::size_t landmarks = kLandmarks.size(),
            std::size_t first = 0) {
    msg::Sightings frame;
    frame.robot = robot;
    frame.view_angle_rad = 7;
    for (std::size_t i = first; i < landmarks; ++i) {
      const Vec2 at_m = rotated(kLandmarks[i].second - truly.position_m, -truly.heading_rad);
      msg::Sighting& item = frame.items.emplace_back();
      item.object_class = kLandmarks[i].first;
      item.x_m = at_m.x();
      item.y_m = at_m.y();
      item.variance_xx = item.variance_yy = 4e-4;
      item.range_m = static_cast<float>(at_m.norm());
      item.left_px = item.top_px = 100;
      item.right_px = item.bottom_px = 120;
    }
    starts.hear(robot);
    for (int i = 0; i < 5; ++i) {
      now += 100ms;
      robots.move(robot, {}, false, now);
      seen.update(frame, now);
    }
  }
  void align(int times) {
    for (int i = 0; i < times; ++i) {
      same.align(now, {});
      same.merge_neighbours();
    }
  }
  void expect_at(const std::string& robot, const Pose2& truly, double within_m, double within_rad) {
    const Pose2 pose = robots.pose(robot);
    EXPECT_LT((pose.position_m - truly.position_m).norm(), within_m);
    EXPECT_LT(std::abs(wrap_angle(pose.heading_rad - truly.heading_rad)), within_rad);
  }

  Starts starts;
  LandmarkIds ids;
  JointGaussian joint;
  RobotPoses robots{joint, starts};
  LandmarkMap seen{joint, robots, ids};
  SameThings same{joint, robots, seen};
  Time now{1s};
};

TEST_F(SameThingsTest, ARobotPlacedRoughlyIsPutRightByWhatOthersSaw) {
  starts.give("ganymede", {});
  starts.give("io", {{0.1, -0.05}, 0.1});
  look("ganymede", {});
  look("io", {});
  align(6);
  EXPECT_EQ(seen.all().size(), kLandmarks.size());
  const Pose2 ganymede = robots.pose("ganymede"), io = robots.pose("io");
  EXPECT_LT((ganymede.position_m - io.position_m).norm(), 0.03);
  EXPECT_LT(std::abs(wrap_angle(ganymede.heading_rad - io.heading_rad)), 0.01);
}

TEST_F(SameThingsTest, ARobotThatStandsQuiteElsewhereIsFound) {
  const Pose2 elsewhere{{3.4, 1.5}, 2.1};
  look("ganymede", {});
  look("io", elsewhere);
  align(12);
  expect_at("io", elsewhere, 0.05, 0.02);
  EXPECT_EQ(seen.all().size(), kLandmarks.size());
}

TEST_F(SameThingsTest, TooFewThingsInCommonMoveNothing) {
  look("ganymede", {});
  look("io", {{3, 1}, 1}, 4);
  align(12);
  expect_at("io", {}, 0.01, 0.01);
}

TEST_F(SameThingsTest, WhatOneRobotSeesAtOnceStaysTwo) {
  msg::Sightings frame;
  frame.robot = "io";
  for (const double y_m : {-0.05, 0.05}) {
    msg::Sighting item;
    item.object_class = "trash";
    item.x_m = 1;
    item.y_m = y_m;
    item.variance_xx = item.variance_yy = 1e-4;
    item.range_m = 1;
    item.left_px = item.top_px = item.right_px = item.bottom_px = 100;
    frame.items.push_back(item);
  }
  for (int i = 0; i < 5; ++i) {
    now += 100ms;
    robots.move("io", {}, false, now);
    seen.update(frame, now);
    same.merge_neighbours();
  }
  EXPECT_EQ(seen.all().size(), 2U);
}

// Its landmarks are no news any more, and so nothing but the others' map tells.
TEST_F(SameThingsTest, ARobotThatMapsAllBesideTheOthersRejoinsThem) {
  const Pose2 stands{{2, 2}, 0.3}, believed{{2.5, 2.4}, 0.3};
  starts.give("callisto", believed);
  starts.give("ganymede", {{1, 1}, 0});
  starts.give("io", {});
  const auto look_at_trash = [this](const std::string& robot, const Pose2& truly) {
    look(robot, truly, kLandmarks.size(), 4);
  };
  for (int i = 0; i < 40; ++i) {
    look_at_trash("io", {});
    look_at_trash("ganymede", {{1, 1}, 0});
    look_at_trash("callisto", stands);
  }
  expect_at("callisto", believed, 0.2, 0.1);
  align(6);
  expect_at("callisto", stands, 0.15, 0.1);
  EXPECT_EQ(seen.all().size(), kLandmarks.size() - 4);
}

// Until it is found out that they are one, there are two; a third robot may go by either.
TEST_F(SameThingsTest, WhatMayBeOneNotedTwiceIsNoRivalOfItself) {
  const auto variance_after_looking = [this](bool seen_as_two) {
    const std::string io = seen_as_two ? "io" : "callisto";
    const Pose2 beside{{1.3, 1.4}, 0};
    starts.give(io, beside);
    look(io, beside, 0);
    const double deviation_m = 0.12;
    for (const double x_m : {1.3, 1.5}) {
      if (!seen_as_two) now += 100ms;
      seen.add_contact("trash", "ganymede",
                       {{x_m, 2.1}, deviation_m * deviation_m * Mat2::Identity()}, 1, now,
                       ids.next());
    }
    look(io, beside, 5, 4);
    const double variance_m2 = robots.position(io).covariance_m2.trace();
    while (!seen.all().empty()) seen.remove(seen.all().front().id);
    return variance_m2;
  };
  look("ganymede", {}, 0);
  EXPECT_LT(variance_after_looking(false), 0.9 * variance_after_looking(true));
}

TEST_F(SameThingsTest, ARobotThatKnowsItIsLostIsFoundByOneBasket) {
  look("ganymede", {}, 4);
  const Pose2 believed{{5.9, 5.2}, 0}, stands{{5.9, 5.2}, 1};
  starts.give("io", believed);
  look("io", believed, 0);
  RobotMatrix lost = RobotMatrix::Zero();
  lost(2, 2) = 1.5;
  joint.blur(robots.part("io"), lost);
  for (int i = 0; i < 3; ++i) look("io", stands, 4, 3);
  EXPECT_LT(std::abs(wrap_angle(robots.pose("io").heading_rad - stands.heading_rad)), 0.25);
}

TEST_F(SameThingsTest, WhatMayBeOneIsToldOnceWhereItIsKnownBest) {
  look("io", {}, 0);
  const auto note = [this](const Vec2& at_m, double deviation_m, Duration after) {
    now += after;
    const auto id = ids.next();
    seen.add_contact("trash", "io", {at_m, deviation_m * deviation_m * Mat2::Identity()}, 1, now,
                     id);
  };
  note({1, 0}, 0.02, 100ms);
  note({1.2, 0.1}, 0.20, 100ms);
  note({2.5, 0}, 0.20, 100ms);
  note({2.7, 0.1}, 0.25, 0ms);
  const auto& all = seen.all();
  EXPECT_FALSE(seen.is_duplicate_candidate(all[0])) << "known best";
  EXPECT_TRUE(seen.is_duplicate_candidate(all[1]));
  EXPECT_FALSE(seen.is_duplicate_candidate(all[2])) << "too far from any other";
  EXPECT_FALSE(seen.is_duplicate_candidate(all[3])) << "seen at once as two";
}

}  // namespace
}  // namespace galilean::monitor
