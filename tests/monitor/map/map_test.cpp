// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "monitor/map/team_map.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

constexpr double kView_rad = 73.5 * kPi / 180;

/// What a camera at `from` sees of landmarks, with 3 cm of error.
msg::Sightings frame(const std::string& robot, const Pose2& from,
                     const std::vector<std::pair<std::string, Vec2>>& landmarks) {
  msg::Sightings result;
  result.robot = robot;
  result.x_m = from.position_m.x();
  result.y_m = from.position_m.y();
  result.heading_rad = from.heading_rad;
  result.view_angle_rad = static_cast<float>(kView_rad);
  for (const auto& [object_class, at] : landmarks) {
    const Vec2 towards = at - from.position_m;
    msg::Sighting& item = result.items.emplace_back();
    item.object_class = object_class;
    item.x_m = at.x();
    item.y_m = at.y();
    item.variance_xx = item.variance_yy = 9e-4;
    item.range_m = static_cast<float>(towards.norm());
    item.azimuth_rad =
        static_cast<float>(wrap_angle(std::atan2(towards.y(), towards.x()) - from.heading_rad));
    item.left_px = item.top_px = item.right_px = item.bottom_px = 100;
  }
  return result;
}

msg::RobotState at(const std::string& robot, const Pose2& pose) {
  msg::RobotState state;
  state.robot = robot;
  state.x_m = pose.position_m.x();
  state.y_m = pose.position_m.y();
  state.heading_rad = pose.heading_rad;
  return state;
}

class MapTest : public testing::Test {
 protected:
  void step(Duration duration = 100ms) { now += duration; }
  msg::ObjectMap objects() {
    map.update(now);
    return map.objects(now, to_ns());
  }
  [[nodiscard]] std::int64_t to_ns() const { return now.time_since_epoch().count(); }

  /// Io stands there by its odometry, and sees these in so many frames.
  void look(const Pose2& from, const std::vector<std::pair<std::string, Vec2>>& landmarks,
            int frames) {
    for (int i = 0; i < frames; ++i, step()) map.add(frame("io", from, landmarks), now);
  }

  TeamMap map{2s};
  Time now{1s};
  const Pose2 io{{0, 0}, 0};
  /// Face to face, 2 m apart; each odom frame begins where its robot stands.
  void place_both() {
    map.start_at("io", io);
    map.start_at("ganymede", {{2, 0}, kPi});
  }
};

TEST_F(MapTest, TwoCansFifteenCentimetresApartStayTwo) {
  place_both();
  for (int i = 0; i < 50; ++i, step()) {
    map.add(frame("io", io, {{"trash", {1, 0.075}}, {"trash", {1, -0.075}}}), now);
    map.add(frame("ganymede", {}, {{"trash", {0.99, -0.085}}, {"trash", {1, 0.065}}}), now);
  }
  const auto seen = objects().objects;
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(std::abs(seen[0].y_m - seen[1].y_m), 0.15, 0.03);
}

TEST_F(MapTest, ACanThatTwoRobotsSeeIsOne) {
  place_both();
  for (int i = 0; i < 10; ++i, step()) {
    map.add(frame("io", io, {{"trash", {1, 0}}}), now);
    map.add(frame("ganymede", {}, {{"trash", {0.95, -0.03}}}), now + 10ms);
  }
  const auto seen = objects().objects;
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].seen_by, (std::vector<std::string>{"ganymede", "io"}));
  EXPECT_NEAR(seen[0].x_m, 1.025, 0.026);
  const auto id = seen[0].id;
  map.add(frame("io", io, {{"trash", {1, 0}}}), now);
  EXPECT_EQ(objects().objects[0].id, id);
}

TEST_F(MapTest, WhatIsNotSeenAnyMoreIsForgottenAfterAMinute) {
  for (int i = 0; i < 30; ++i, step()) map.add(frame("io", io, {{"trash", {3, 0}}}), now);
  EXPECT_NEAR(objects().objects[0].certainty, 1, 0.01);
  step(30s);
  EXPECT_NEAR(objects().objects[0].certainty, 0.5, 0.01);
  step(31s);
  EXPECT_TRUE(objects().objects.empty());
}

TEST_F(MapTest, WhatIsMissingInTheVisibleAreaIsForgottenSoon) {
  for (int i = 0; i < 30; ++i, step()) map.add(frame("io", io, {{"trash", {1, 0}}}), now);
  for (int i = 0; i < 35; ++i, step()) map.add(frame("io", io, {}), now);
  EXPECT_TRUE(objects().objects.empty());
}

TEST_F(MapTest, WhatSomethingNearerHidesIsNotMissing) {
  for (int i = 0; i < 30; ++i, step()) map.add(frame("io", io, {{"trash", {1.2, 0}}}), now);
  for (int i = 0; i < 35; ++i, step()) map.add(frame("io", io, {{"robot", {0.6, 0.02}}}), now);
  EXPECT_EQ(objects().objects.size(), 1U);
}

TEST_F(MapTest, ASilentRobotStaysWhereItWas) {
  map.add(at("io", {{1, 2}, 0.5}), now);
  step(10s);
  const auto robots = objects().robots;
  ASSERT_EQ(robots.size(), 1U);
  EXPECT_TRUE(robots[0].silent);
  EXPECT_FLOAT_EQ(robots[0].age_s, 10);
  EXPECT_DOUBLE_EQ(robots[0].x_m, 1);
}

TEST_F(MapTest, AGivenStartPlacesTheRobotAndItsFrame) {
  map.start_at("io", {{3, 1}, kPi / 2});
  map.add(at("io", {{1, 0}, 0}), now);
  const auto robot = objects().robots.at(0);
  EXPECT_NEAR(robot.x_m, 3, 1e-9);
  EXPECT_NEAR(robot.y_m, 2, 1e-9);
  EXPECT_NEAR(robot.heading_rad, kPi / 2, 1e-9);
  const auto frames = map.transforms(to_ns()).transforms;
  EXPECT_EQ(frames.at(0).child_frame_id, "io/odom");
  EXPECT_NEAR(frames[0].transform.rotation.z, std::sin(kPi / 4), 1e-9);
}

// Its treads slip: the odometer counts a turn that the camera does not see.
TEST_F(MapTest, ARobotThatTurnedLessThanItsOdometerSaysIsTurnedBack) {
  map.start_at("io", io);
  const std::vector<std::pair<std::string, Vec2>> around{
      {"basket", {1.6, 0.5}}, {"trash", {1, -0.4}}, {"trash", {2.2, -0.3}}};
  look(io, around, 150);
  constexpr double kSlip_rad = 0.6;
  auto counted = around;
  for (auto& [object_class, at_m] : counted) at_m = rotated(at_m, kSlip_rad);
  look({{0, 0}, kSlip_rad}, counted, 20);
  const auto published = objects();
  EXPECT_NEAR(published.robots.at(0).heading_rad, 0, 0.06);
  EXPECT_EQ(published.objects.size(), around.size());
}

/// A robot that knew trash for long, and then drove back for more than a metre without seeing any:
/// its heading is known to a tenth of a radian.
class UncertainRobotTest : public MapTest {
 protected:
  void know(const std::vector<std::pair<std::string, Vec2>>& landmarks) {
    map.start_at("io", io);
    look(io, landmarks, 150);
    for (int i = 0; i <= 20; ++i, step()) map.add(at("io", {{-0.06 * i, 0}, 0}), now);
  }
  [[nodiscard]] double heading_rad() { return objects().robots.at(0).heading_rad; }

  const Pose2 behind{{-1.2, 0}, 0};
};

// It may be another piece.
TEST_F(UncertainRobotTest, IsNotTurnedByOnePieceBesideAKnownOne) {
  know({{"trash", {1, 0}}});
  look(behind, {{"trash", {1, 0.25}}}, 3);
  EXPECT_NEAR(heading_rad(), 0, 0.01);
}

TEST_F(UncertainRobotTest, IsTurnedByTwoPiecesThatLieAsKnownOnesDo) {
  const std::vector<std::pair<std::string, Vec2>> known{{"trash", {1, 0}}, {"trash", {0.6, -0.8}}};
  know(known);
  constexpr double kSlip_rad = 0.1;
  auto counted = known;
  for (auto& [object_class, at_m] : counted)
    at_m = behind.position_m + rotated(at_m - behind.position_m, kSlip_rad);
  look(behind, counted, 3);
  EXPECT_NEAR(heading_rad(), -kSlip_rad, 0.05);
}

TEST_F(UncertainRobotTest, IsTurnedByABasketBecauseTheseStandMetresApart) {
  know({{"basket", {1, 0}}});
  look(behind, {{"basket", {1, 0.25}}}, 3);
  EXPECT_LT(heading_rad(), -0.05);
}

TEST_F(MapTest, AStrangePlaceThatLooksLikeAKnownOneTurnsNobody) {
  map.start_at("io", io);
  const std::vector<std::pair<std::string, Vec2>> known{
      {"trash", {1.6, 0.5}}, {"trash", {1, -0.4}}, {"trash", {2.2, -0.3}}};
  look(io, known, 150);
  constexpr double kTurned_rad = 1.2;
  for (double turned_rad = 0; turned_rad < kTurned_rad; turned_rad += 0.1, step())
    map.add(at("io", {{0, 0}, turned_rad}), now);
  auto alike = known;
  for (auto& [object_class, at_m] : alike) at_m = rotated(at_m, kTurned_rad);
  look({{0, 0}, kTurned_rad}, alike, 20);
  const auto published = objects();
  EXPECT_NEAR(published.robots.at(0).heading_rad, kTurned_rad, 0.06);
  EXPECT_EQ(published.objects.size(), known.size() + alike.size());
}

// Its treads slipped on: the odometer counts a way that it did not go.
TEST_F(MapTest, ABasketBesideWhereItIsKnownPutsTheRobotBack) {
  map.start_at("io", io);
  const Vec2 basket_m(1.6, 0.5);
  for (int i = 0; i < 50; ++i, step()) map.add(frame("io", io, {{"basket", basket_m}}), now);
  Vec2 counted_m(0, 0);
  for (; counted_m.x() < 0.65; counted_m.x() += 0.1, step()) map.add(at("io", {counted_m, 0}), now);
  for (int i = 0; i < 20; ++i, step())
    map.add(frame("io", {counted_m, 0}, {{"basket", basket_m + counted_m}}), now);
  const auto published = objects();
  EXPECT_NEAR(published.robots.at(0).x_m, 0, 0.2);
  EXPECT_EQ(published.objects.size(), 1U);
}

}  // namespace
}  // namespace galilean::monitor
