// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/schema_test.h"

namespace galilean::robot {
namespace {

using namespace std::string_literals;
using Names = std::vector<std::string>;

class ScannerTest : public SchemaTest {
 protected:
  ScannerTest() { bits().constant = false; }

  Variable<Bits>& bits() { return variable<Bits>("bits"); }
  bool bit_after(Schema& schema, unsigned index) {
    advance();
    schema.run(tick);
    EXPECT_EQ(bits().written_tick, tick.number);
    return bits().value.test(index);
  }
};

TEST_F(ScannerTest, BumperScannerCopiesAllSwitchesOrOne) {
  const auto all = make("bumper_scanner", {{"bits_variable", "bits"s}});
  comm_port.state.bumpers = 0b10000101;
  all->run(tick);
  EXPECT_EQ(bits().value.value, 0b10000101u);
  const auto one = make("bumper_scanner", {{"bits_variable", "bits"s}, {"bit_index", 2.0}});
  comm_port.state.bumpers = 0;
  one->run(tick);
  EXPECT_EQ(bits().value.value, 0b10000001u);
}

TEST_F(ScannerTest, ScannersAreSilentWhileTheLineIsDown) {
  comm_port.up = false;
  advance();
  make("bumper_scanner", {{"bits_variable", "bits"s}})->run(tick);
  make("gripper_scanner", {{"bits_variable", "bits"s}})->run(tick);
  EXPECT_NE(bits().written_tick, tick.number);
  EXPECT_FALSE(bits().valid_at(tick.now));
}

TEST_F(ScannerTest, GripperScannerTellsBeamAndServo) {
  const auto scan = make("gripper_scanner",
                         {{"bits_variable", "bits"s}, {"beam_index", 0.0}, {"closed_index", 4.0}});
  EXPECT_FALSE(bit_after(*scan, 0));
  comm_port.state.beam_broken = true;
  EXPECT_TRUE(bit_after(*scan, 0));
  EXPECT_FALSE(bits().value.test(4));
  comm_port.state.gripper_closed = true;
  EXPECT_TRUE(bit_after(*scan, 4));
}

TEST_F(ScannerTest, TimeDetectorCountsFromActivation) {
  const auto timer =
      make("time_detector", {{"bits_variable", "bits"s}, {"bit_index", 1.0}, {"duration", 0.3}});
  advance(100);
  timer->activate(tick);
  timer->run(tick);
  EXPECT_FALSE(bits().value.test(1));
  tick.now += from_seconds(0.3) - Duration(1);
  timer->run(tick);
  EXPECT_FALSE(bits().value.test(1));
  tick.now += Duration(1);
  timer->run(tick);
  EXPECT_TRUE(bits().value.test(1));
  timer->activate(tick);
  EXPECT_FALSE(bit_after(*timer, 1));
}

class MemoryTest : public ScannerTest {};

TEST_F(MemoryTest, ObstacleDetectorLeavesTheObstacleWhereItWasTouched) {
  auto& obstacle = variable<Locate>("obstacle");
  const auto touch = make("obstacle_detector", {{"bits_variable", "bits"s},
                                                {"bit_index", 1.0},
                                                {"translation", Vec2(-0.1, 0.2)},
                                                {"obstacle_variable", "obstacle"s}});
  shaft().value.pose = {{3, 1}, 0};  // faces along x: its right is -y
  bits().write({0}, 1, tick.now, tick.number);
  touch->run(tick);
  EXPECT_FALSE(obstacle.valid_at(tick.now));
  bits().write({2}, 1, tick.now, tick.number);
  touch->run(tick);
  EXPECT_LT((obstacle.value.position_m - Vec2(3.2, 1.1)).norm(), 1e-9);
  bits().write({0}, 1, tick.now, tick.number);
  shaft().value.pose = {{0, 0}, 2};
  touch->run(tick);
  EXPECT_LT((obstacle.value.position_m - Vec2(3.2, 1.1)).norm(), 1e-9);
}

TEST_F(MemoryTest, AnObstacleIsBeforeTheRobotUnlessTheProgramSaysWhere) {
  auto& obstacle = locate("obstacle", {0, 0});
  bits().write({1}, 1, tick.now, tick.number);
  make("obstacle_detector", {{"bits_variable", "bits"s}, {"obstacle_variable", "obstacle"s}})
      ->run(tick);
  EXPECT_LT((obstacle.value.position_m - point_to_global(shaft().value.pose, {0, 0.22})).norm(),
            1e-9);
}

TEST_F(MemoryTest, ForgetSetsTheRateOfVariablesOfEveryType) {
  auto& trash = locate("trash", {1, 1});
  bits().write({1}, 1, tick.now, tick.number);
  make("forget", {{"variables", Names{"trash", "bits"}}, {"time", 10.0}})->run(tick);
  advance(4);
  EXPECT_NEAR(trash.certainty_at(tick.now), 0.6, 1e-9);
  EXPECT_NEAR(bits().certainty_at(tick.now), 0.6, 1e-9);
  advance(6);
  EXPECT_FALSE(trash.valid_at(tick.now));
  make("forget", {{"variables", Names{"trash"}}, {"time", 0.0}})->run(tick);
  EXPECT_EQ(trash.certainty_at(tick.now), 1);
}

class TriggerTest : public ScannerTest {};

TEST_F(TriggerTest, SeenNeedsCertaintyAndRange) {
  const double certain = 0.5;
  auto& object = locate("object", {0, 1}, 0, certain);
  object.reliability.decay_per_s = 0;
  const auto seen = make("seen", {{"locate_variable", "object"s},
                                  {"min_certainty", 0.5},
                                  {"max_range", 1.0},
                                  {"bits_variable", "bits"s},
                                  {"bit_index", 5.0}});
  EXPECT_TRUE(bit_after(*seen, 5));
  object.reliability.certainty = certain - 1e-9;
  EXPECT_FALSE(bit_after(*seen, 5));
  object.reliability.certainty = certain;
  object.value.position_m = {0, 1 + 1e-9};
  EXPECT_FALSE(bit_after(*seen, 5));
  object.value.position_m = {0, 1};
  object.reset(tick.now);
  EXPECT_FALSE(bit_after(*seen, 5));
}

TEST_F(TriggerTest, LostIsTheOppositeBelowItsOwnCertainty) {
  auto& object = locate("object", {0, 1}, 0, 0.2);
  object.reliability.decay_per_s = 0;
  const auto lost = make(
      "lost", {{"locate_variable", "object"s}, {"min_certainty", 0.2}, {"bits_variable", "bits"s}});
  EXPECT_FALSE(bit_after(*lost, 0));
  object.reliability.certainty = 0.2 - 1e-9;
  EXPECT_TRUE(bit_after(*lost, 0));
  object.reset(tick.now);
  EXPECT_TRUE(bit_after(*lost, 0));
}

TEST_F(TriggerTest, ArrivedIsWithinTheRadiusOfAValidObject) {
  auto& object = locate("object", {0, 0.4});
  const auto arrived = make(
      "arrived", {{"locate_variable", "object"s}, {"radius", 0.4}, {"bits_variable", "bits"s}});
  EXPECT_TRUE(bit_after(*arrived, 0));
  object.value.position_m = {0, 0.4 + 1e-9};
  EXPECT_FALSE(bit_after(*arrived, 0));
  object.value.position_m = {0, 0.1};
  EXPECT_TRUE(bit_after(*arrived, 0));
  object.reset(tick.now);
  EXPECT_FALSE(bit_after(*arrived, 0));
}

}  // namespace
}  // namespace galilean::robot
