// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/relocalization/landmark_merger.h"

#include <gtest/gtest.h>

#include "monitor/map/estimation/motion_model.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

/// Landmarks of an office, in the map frame; no two correspondences are equally far apart.
const std::vector<std::pair<std::string, Vec2>> kLandmarks{
    {"basket", {0.7, 4.2}}, {"basket", {3.6, 3.4}}, {"basket", {4.8, 0.6}}, {"basket", {7.4, 5.2}},
    {"trash", {1.3, 2.1}},  {"trash", {2.9, 1.2}},  {"trash", {5.5, 2.7}},  {"trash", {6.3, 4.4}},
    {"trash", {2.2, 5.1}},  {"trash", {4.1, 4.9}}};

class LandmarkMergerTest : public testing::Test {
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
    origins.hear(robot);
    for (int i = 0; i < 5; ++i) {
      now += 100ms;
      robots.predict(robot, {}, false, now);
      map.update(frame, now);
    }
  }
  void align(int times) {
    for (int i = 0; i < times; ++i) {
      merger.align(now, {});
      merger.merge_neighbours();
    }
  }
  void expect_at(const std::string& robot, const Pose2& truly, double within_m, double within_rad) {
    const Pose2 pose = robots.pose(robot);
    EXPECT_LT((pose.position_m - truly.position_m).norm(), within_m);
    EXPECT_LT(std::abs(wrap_angle(pose.heading_rad - truly.heading_rad)), within_rad);
  }

  OdomOrigins origins;
  LandmarkIds ids;
  JointGaussian joint;
  RobotPoses robots{joint, origins};
  LandmarkMap map{joint, robots, ids};
  LandmarkMerger merger{joint, robots, map};
  Time now{1s};
};

TEST_F(LandmarkMergerTest, ARobotPlacedRoughlyIsPutRightByWhatOthersSaw) {
  origins.set("ganymede", {});
  origins.set("io", {{0.1, -0.05}, 0.1});
  look("ganymede", {});
  look("io", {});
  align(6);
  EXPECT_EQ(map.all().size(), kLandmarks.size());
  const Pose2 ganymede = robots.pose("ganymede"), io = robots.pose("io");
  EXPECT_LT((ganymede.position_m - io.position_m).norm(), 0.03);
  EXPECT_LT(std::abs(wrap_angle(ganymede.heading_rad - io.heading_rad)), 0.01);
}

TEST_F(LandmarkMergerTest, ARobotThatStandsQuiteElsewhereIsFound) {
  const Pose2 elsewhere{{3.4, 1.5}, 2.1};
  look("ganymede", {});
  look("io", elsewhere);
  align(12);
  expect_at("io", elsewhere, 0.05, 0.02);
  EXPECT_EQ(map.all().size(), kLandmarks.size());
}

TEST_F(LandmarkMergerTest, TooFewLandmarksInCommonMoveNothing) {
  look("ganymede", {});
  look("io", {{3, 1}, 1}, 4);
  align(12);
  expect_at("io", {}, 0.01, 0.01);
}

TEST_F(LandmarkMergerTest, WhatOneRobotSeesAtOnceStaysTwo) {
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
    robots.predict("io", {}, false, now);
    map.update(frame, now);
    merger.merge_neighbours();
  }
  EXPECT_EQ(map.all().size(), 2U);
}

// Its landmarks are not recent any more, so that only the others' map tells.
TEST_F(LandmarkMergerTest, ARobotThatMapsAllBesideTheOthersRejoinsThem) {
  const Pose2 stands{{2, 2}, 0.3}, believed{{2.5, 2.4}, 0.3};
  origins.set("callisto", believed);
  origins.set("ganymede", {{1, 1}, 0});
  origins.set("io", {});
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
  EXPECT_EQ(map.all().size(), kLandmarks.size() - 4);
}

// Until duplicates are merged there are two landmarks. A third robot may be corrected by either.
TEST_F(LandmarkMergerTest, DuplicatesOfOneObjectAreNoRivals) {
  const auto variance_after_looking = [this](bool seen_as_two) {
    const std::string io = seen_as_two ? "io" : "callisto";
    const Pose2 beside{{1.3, 1.4}, 0};
    origins.set(io, beside);
    look(io, beside, 0);
    const double deviation_m = 0.12;
    for (const double x_m : {1.3, 1.5}) {
      if (!seen_as_two) now += 100ms;
      map.add_contact("trash", "ganymede",
                      {{x_m, 2.1}, deviation_m * deviation_m * Mat2::Identity()}, 1, now,
                      ids.next());
    }
    look(io, beside, 5, 4);
    const double variance_m2 = robots.position(io).covariance_m2.trace();
    while (!map.all().empty()) map.remove(map.all().front().id);
    return variance_m2;
  };
  look("ganymede", {}, 0);
  EXPECT_LT(variance_after_looking(false), 0.9 * variance_after_looking(true));
}

TEST_F(LandmarkMergerTest, ARobotThatKnowsItIsLostIsFoundByOneBasket) {
  look("ganymede", {}, 4);
  const Pose2 believed{{5.9, 5.2}, 0}, stands{{5.9, 5.2}, 1};
  origins.set("io", believed);
  look("io", believed, 0);
  RobotMatrix lost = RobotMatrix::Zero();
  lost(2, 2) = 1.5;
  joint.inflate(robots.block("io"), lost);
  for (int i = 0; i < 3; ++i) look("io", stands, 4, 3);
  EXPECT_LT(std::abs(wrap_angle(robots.pose("io").heading_rad - stands.heading_rad)), 0.25);
}

TEST_F(LandmarkMergerTest, WhatMayBeOneIsPublishedOnceWhereItIsKnownBest) {
  look("io", {}, 0);
  const auto add_contact = [this](const Vec2& at_m, double deviation_m, Duration after) {
    now += after;
    const auto id = ids.next();
    map.add_contact("trash", "io", {at_m, deviation_m * deviation_m * Mat2::Identity()}, 1, now,
                    id);
  };
  add_contact({1, 0}, 0.02, 100ms);
  add_contact({1.2, 0.1}, 0.20, 100ms);
  add_contact({2.5, 0}, 0.20, 100ms);
  add_contact({2.7, 0.1}, 0.25, 0ms);
  const auto& all = map.all();
  EXPECT_FALSE(map.is_duplicate_candidate(all[0])) << "known best";
  EXPECT_TRUE(map.is_duplicate_candidate(all[1]));
  EXPECT_FALSE(map.is_duplicate_candidate(all[2])) << "too far from any other";
  EXPECT_FALSE(map.is_duplicate_candidate(all[3])) << "seen at once as two";
}

}  // namespace
}  // namespace galilean::monitor
