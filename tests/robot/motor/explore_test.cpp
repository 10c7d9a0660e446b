// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/motor/force_test.h"

namespace galilean::robot {
namespace {

using Names = std::vector<std::string>;

class NoiseTest : public ForceTest {
 protected:
  std::unique_ptr<Schema> schema_ =
      make("noise", {{"shaft_variable", "shaft"s}, {"persistence", 5.0}, {"result", "result"s}});
};

TEST_F(NoiseTest, HoldsAUnitVectorForItsPersistence) {
  schema_->activate(tick);
  const Time drawn = tick.now;
  const Vec2 first = run(*schema_);
  EXPECT_NEAR(first.norm(), 1, kTolerance);
  tick.now = drawn + from_seconds(5) - Duration(1);
  schema_->run(tick);
  EXPECT_EQ(result().value.value, first);
  tick.now += Duration(1);
  schema_->run(tick);
  EXPECT_GT((result().value.value - first).norm(), 1e-3);
  EXPECT_NEAR(result().value.value.norm(), 1, kTolerance);
}

TEST_F(NoiseTest, HoldsItsHeadingInTheWorldWhileTheRobotTurns) {
  schema_->activate(tick);
  const Vec2 before = direction_to_global(shaft().value.pose, run(*schema_));
  shaft().value.pose.heading_rad = 0.3;
  expect_near(direction_to_global(shaft().value.pose, run(*schema_)), before);
}

TEST_F(NoiseTest, DrawsAnewWhenActivatedAndTheSameForTheSameSeed) {
  const auto twin =
      make("noise", {{"shaft_variable", "shaft"s}, {"persistence", 5.0}, {"result", "result"s}});
  schema_->activate(tick);
  const Vec2 first = run(*schema_);
  twin->activate(tick);
  EXPECT_EQ(run(*twin), first);
  schema_->activate(tick);
  EXPECT_GT((run(*schema_) - first).norm(), 1e-3);
}

TEST_F(NoiseTest, IsSilentWithoutAShaft) {
  shaft().reset(tick.now);
  expect_silence(*schema_);
}

class ProbeTest : public ForceTest {
 protected:
  static constexpr double kSector = kPi / 6;

  ProbeTest() {
    Names names;
    for (int i = 0; i < 12; ++i) {
      names.push_back("o" + std::to_string(i));
      variable<Locate>(names.back());
    }
    schema_ = make("probe", {{"shaft_variable", "shaft"s},
                             {"obstacle_variables", names},
                             {"range", 1.0},
                             {"result", "result"s}});
  }
  /// Counter-clockwise from straight ahead.
  void block(int sector, double distance_m = 0.5, double radius_m = 0, double off_rad = 0) {
    const double bearing = sector * kSector + off_rad;
    locate("o" + std::to_string(sector), distance_m * unit_vector(kPi / 2 + bearing), radius_m);
  }
  Vec2 sector(int i) { return unit_vector(kPi / 2 + i * kSector); }

  std::unique_ptr<Schema> schema_;
};

TEST_F(ProbeTest, GoesAheadWhereNothingIsInTheWay) {
  expect_near(run(*schema_), {0, 1});
}

TEST_F(ProbeTest, TakesTheClearSectorNearestToAhead) {
  block(0);
  expect_near(run(*schema_), sector(1) * (5.0 / 6));
  block(1);
  expect_near(run(*schema_), sector(-1) * (5.0 / 6));
  block(11);
  block(2);
  expect_near(run(*schema_), sector(-2) * (4.0 / 6));
}

TEST_F(ProbeTest, PullsNowhereBehindOrWhenAllIsBlocked) {
  for (int i = 0; i < 12; ++i)
    if (i != 6) block(i);
  expect_near(run(*schema_), {0, 0});
  block(6);
  expect_near(run(*schema_), {0, 0});
}

TEST_F(ProbeTest, LooksAsFarAsItsRangeAndAsWideAsTheSector) {
  block(0, 1.0 + 1e-6);
  expect_near(run(*schema_), {0, 1});
  block(0, 1.0);
  expect_near(run(*schema_), sector(1) * (5.0 / 6));
  block(0, 0.5, 0, kSector / 2 + 1e-6);
  expect_near(run(*schema_), {0, 1});
  block(0, 0.5, 0, kSector / 2 - 1e-6);
  expect_near(run(*schema_), sector(1) * (5.0 / 6));
}

TEST_F(ProbeTest, GivesWideObstaclesTheirWidth) {
  block(0, 0.5, 0.5 * std::sin(kSector / 2 + 0.01));
  expect_near(run(*schema_), sector(2) * (4.0 / 6));
  block(0, 0.2, 0.3);
  expect_near(run(*schema_), {0, 0});
}

TEST_F(ProbeTest, IsSilentWithoutAShaft) {
  shaft().reset(tick.now);
  expect_silence(*schema_);
}

}  // namespace
}  // namespace galilean::robot
