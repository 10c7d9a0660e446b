// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "monitor/map/groups/share_landmarks.h"
#include "monitor/map/team_map.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

constexpr double kCameraView_rad = 73.5 * kPi / 180;

TEST(RobotGroups, ATeamThatFitsIntoOneIsNotDivided) {
  RobotGroups groups(4);
  for (const double x_m : {0.0, 30.0, 60.0, 90.0}) {
    const std::string robot = std::to_string(x_m);
    groups.join(robot, {{x_m, 0}, 0}).poses.predict(robot, {{x_m, 0}, 0}, false, Time(1s));
  }
  EXPECT_EQ(groups.all().size(), 1U);
}

TEST(RobotGroups, ALargerTeamIsDividedByNearness) {
  RobotGroups groups(2);
  const auto join = [&](const std::string& robot, double x_m) -> RobotGroup& {
    RobotGroup& group = groups.join(robot, {{x_m, 0}, 0});
    group.poses.predict(robot, {{x_m, 0}, 0}, false, Time(1s));
    return group;
  };
  join("a", 0);
  join("b", 1);
  RobotGroup &c = join("c", 2), &d = join("d", 30);
  EXPECT_NE(&c, &d) << "too far away";
  EXPECT_EQ(&join("e", 4), &c);
  EXPECT_EQ(&join("f", 28), &d);
  EXPECT_EQ(&join("c", 50), &c) << "it stays where it is";
}

TEST(RobotGroups, AGroupThatNobodyIsLeftInIsDissolvedButTheFirst) {
  RobotGroups groups(2);
  const auto join = [&](const std::string& robot, double x_m) {
    groups.join(robot, {{x_m, 0}, 0}).poses.predict(robot, {{x_m, 0}, 0}, false, Time(1s));
  };
  join("a", 0);
  join("b", 1);
  join("c", 30);
  EXPECT_EQ(groups.leave("a"), nullptr) << "b is left in it";
  EXPECT_EQ(groups.leave("b"), nullptr) << "it is the first";
  EXPECT_NE(groups.leave("c"), nullptr);
  EXPECT_EQ(groups.all().size(), 1U);
  EXPECT_TRUE(groups.robots().empty());
  join("d", 2);
  EXPECT_EQ(&groups.of("d"), groups.all().front().get());
  EXPECT_EQ(groups.of("d").poses.all().size(), 1U);
}

/// Two robots, each a group of its own: their estimates share no errors.
class DividedTeamTest : public testing::Test {
 protected:
  /// `robot` stands at `truly` and its odometer at 0: what it sees of the landmarks, exactly.
  [[nodiscard]] static msg::Sightings frame(const std::string& robot, const Pose2& truly,
                                            const std::vector<Vec2>& trash,
                                            double view_rad = kCameraView_rad) {
    msg::Sightings result;
    result.robot = robot;
    result.view_angle_rad = static_cast<float>(view_rad);
    for (const Vec2& at_m : trash) {
      const Vec2 seen_m = rotated(at_m - truly.position_m, -truly.heading_rad);
      msg::Sighting& item = result.items.emplace_back();
      item.object_class = "trash";
      item.x_m = seen_m.x();
      item.y_m = seen_m.y();
      item.variance_xx = item.variance_yy = 4e-4;
      item.range_m = static_cast<float>(seen_m.norm());
      item.azimuth_rad = static_cast<float>(std::atan2(seen_m.y(), seen_m.x()));
      item.left_px = item.top_px = item.right_px = item.bottom_px = 100;
    }
    return result;
  }
  void look(const msg::Sightings& frame, int frames = 10) {
    for (int i = 0; i < frames; ++i) {
      now += 100ms;
      map.add(frame, now);
      map.update(now);
    }
  }
  msg::ObjectMap published() {
    map.update(now);
    return map.objects(now, now.time_since_epoch().count());
  }
  [[nodiscard]] Vec2 robot_m(std::size_t index) {
    const auto robot = published().robots.at(index);
    return {robot.x_m, robot.y_m};
  }

  TeamMap map{2s, 1};
  Time now{1s};
  const Pose2 io{{0, 0}, 0}, ganymede{{2, 0}, kPi};
};

TEST_F(DividedTeamTest, ACanThatTwoGroupsSeeIsOne) {
  map.start_at("io", io);
  map.start_at("ganymede", ganymede);
  look(frame("io", io, {{1, 0}}));
  const auto before = published().objects;
  ASSERT_EQ(before.size(), 1U);
  look(frame("ganymede", ganymede, {{1.03, 0.02}}));
  const auto after = published().objects;
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ(after[0].id, before[0].id);
  EXPECT_EQ(after[0].seen_by, (std::vector<std::string>{"ganymede", "io"}));
}

TEST_F(DividedTeamTest, ARobotThatIsForgottenLeavesTheMapAndMayComeBack) {
  map.start_at("io", io);
  map.start_at("ganymede", ganymede);
  look(frame("io", io, {{1, 0}}));
  look(frame("ganymede", ganymede, {{1.03, 0.02}}));
  map.forget("ganymede");
  const auto without = published();
  ASSERT_EQ(without.robots.size(), 1U);
  EXPECT_EQ(without.robots[0].name, "io");
  EXPECT_EQ(without.objects.size(), 1U) << "io saw the can, too";
  EXPECT_EQ(map.transforms(1).transforms.size(), 1U);
  map.forget("ganymede");
  look(frame("ganymede", ganymede, {{1.03, 0.02}}));
  EXPECT_EQ(published().robots.size(), 2U);
  map.forget("io");
  map.forget("ganymede");
  EXPECT_TRUE(published().robots.empty());
  look(frame("callisto", io, {{1, 0}}));
  EXPECT_EQ(published().robots.size(), 1U);
}

TEST_F(DividedTeamTest, TwoCansFifteenCentimetresApartStayTwo) {
  map.start_at("io", io);
  map.start_at("ganymede", ganymede);
  for (int i = 0; i < 10; ++i) {
    look(frame("io", io, {{1, 0.075}, {1, -0.075}}), 1);
    look(frame("ganymede", ganymede, {{1, 0.065}, {0.99, -0.085}}), 1);
  }
  const auto seen = published().objects;
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0].seen_by.size(), 2U);
  EXPECT_NEAR(std::abs(seen[0].y_m - seen[1].y_m), 0.15, 0.03);
}

/// Nobody said where either starts. The map frame is callisto's odom frame, and io stands
/// elsewhere.
class UnlocalizedGroupTest : public DividedTeamTest {
 protected:
  UnlocalizedGroupTest() {
    for (int i = 0; i < 40; ++i) both_look(trash);
  }
  void both_look(const std::vector<Vec2>& io_sees) {
    look(frame("callisto", {}, trash, 7), 1);
    look(frame("io", elsewhere, io_sees, 7), 1);
  }

  const Pose2 elsewhere{{3.4, 1.5}, 2.1};
  const std::vector<Vec2> trash{{1.3, 2.1}, {2.9, 1.2}, {5.5, 2.7}, {6.3, 4.4}, {2.2, 5.1},
                                {4.1, 4.9}, {0.7, 4.2}, {3.6, 3.4}, {4.8, 0.6}, {7.4, 5.2}};
};

TEST_F(UnlocalizedGroupTest, IsFoundByWhatItSaw) {
  EXPECT_LT(robot_m(0).norm(), 0.05) << "its frame is the map's";
  EXPECT_LT((robot_m(1) - elsewhere.position_m).norm(), 0.05);
  EXPECT_EQ(published().objects.size(), trash.size());
}

TEST_F(UnlocalizedGroupTest, WhatAnotherGroupMissesInItsVisibleAreaIsForgotten) {
  auto with_another = trash;
  with_another.push_back(elsewhere.position_m + Vec2(1.2, 0.9));
  look(frame("callisto", {}, with_another, 7));
  EXPECT_EQ(published().objects.size(), with_another.size());
  look(frame("io", elsewhere, trash, 7), 30);
  EXPECT_EQ(published().objects.size(), trash.size());
}

TEST_F(UnlocalizedGroupTest, WhereARobotStandsLiesNoTrashOfAnotherGroup) {
  auto with_another = trash;
  with_another.push_back(elsewhere.position_m + 0.3 * unit_vector(elsewhere.heading_rad));
  look(frame("callisto", {}, with_another, 7));
  EXPECT_EQ(published().objects.size(), with_another.size());
  msg::RobotState there;
  there.robot = "io";
  there.x_m = 0.3;
  map.add(there, now += 1s);
  EXPECT_EQ(published().objects.size(), trash.size());
}

/// Both believe that they stand at 0, and io does: its odom frame is the map frame.
class ShareLandmarksTest : public testing::Test {
 protected:
  ShareLandmarksTest() {
    learns.is_localized = true;
    add_trash("io", knows, {0, 0});
    add_trash("ganymede", learns, truly_m);
  }
  void add_trash(const std::string& robot, RobotGroup& group, const Vec2& stands_m) {
    group.poses.predict(robot, {}, false, now);
    for (const Vec2& at_m : {Vec2(1, 0.5), Vec2(1.2, -0.3), Vec2(0.8, 0.1)})
      group.landmarks.add_contact("trash", robot, {at_m - stands_m, 1e-4 * Mat2::Identity()}, 1,
                                  now, groups.next_id());
  }
  void share() {
    const auto landmarks = landmarks_by_group(groups);
    share_landmarks(landmarks, duplicate_pairs(landmarks));
  }

  RobotGroups groups{1};
  RobotGroup& knows = groups.join("io", {});
  RobotGroup& learns = groups.join("ganymede", {});
  const Vec2 truly_m{0.1, 0.05};
  const Time now{1s};
};

TEST_F(ShareLandmarksTest, AGroupBelievesAnotherThatKnowsFarBetter) {
  share();
  EXPECT_LT((learns.poses.pose("ganymede").position_m - truly_m).norm(), 0.05);
  EXPECT_EQ(knows.poses.pose("io").position_m.norm(), 0);
}

TEST_F(ShareLandmarksTest, ASharedEstimateIsNeverAsSureAsAnOwnOne) {
  for (int i = 0; i < 100; ++i) share();
  const double variance_m2 = learns.poses.position("ganymede").covariance_m2.trace();
  EXPECT_GT(variance_m2, 2 * 0.025 * 0.025);
  EXPECT_GT(variance_m2, 4 * knows.poses.position("io").covariance_m2.trace());
}

TEST(CarriedObjects, WhatIsPickedUpLeavesTheFloorWhoeverSawIt) {
  RobotGroups groups(1);
  groups.start_at("io", {});
  groups.start_at("ganymede", {{0.6, 0}, kPi});
  const Time now{1s};
  constexpr double kNear_m2 = 1e-4;
  for (const std::string robot : {"io", "ganymede"}) {
    RobotGroup& group = groups.join(robot, {});
    group.poses.predict(robot, {}, false, now);
    for (int i = 0; i < 3; ++i)
      group.landmarks.add_contact("trash", robot, {{0.3, 0}, kNear_m2 * Mat2::Identity()}, 1, now,
                                  groups.next_id());
    for (int i = 0; i < 2; ++i) group.landmarks.remove(group.landmarks.all().front().id);
  }
  auto landmarks = landmarks_by_group(groups);
  const auto pairs = duplicate_pairs(landmarks);
  const auto published = merged(std::move(landmarks), pairs);
  ASSERT_EQ(published.size(), 1U);
  CarriedObjects carried(groups);
  carried.update("io", true, published, now);
  ASSERT_EQ(carried.all().size(), 1U);
  EXPECT_EQ(carried.all().at("io").id, published[0].id);
  EXPECT_EQ(carried.all().at("io").seen_by.size(), 2U);
  EXPECT_TRUE(landmarks_by_group(groups).empty());
  carried.update("io", false, published, now);
  EXPECT_EQ(landmarks_by_group(groups).size(), 1U) << "put down where no basket is";
}

// A leg of a table, say, which nobody took for trash.
TEST(CarriedObjects, WhatBreaksTheBeamAndStoodOnNoMapIsNotPutDown) {
  RobotGroups groups(4);
  const Time now{1s};
  groups.join("io", {}).poses.predict("io", {}, false, now);
  CarriedObjects carried(groups);
  carried.update("io", true, {}, now);
  EXPECT_EQ(carried.all().size(), 1U);
  carried.update("io", false, {}, now);
  EXPECT_TRUE(carried.all().empty());
  EXPECT_TRUE(groups.of("io").landmarks.all().empty());
}

}  // namespace
}  // namespace galilean::monitor
