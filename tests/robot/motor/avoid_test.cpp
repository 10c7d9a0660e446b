// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/motor/force_test.h"

namespace galilean::robot {
namespace {

class AvoidObstacleTest : public ForceTest {
 protected:
  std::unique_ptr<Schema> schema() {
    variable<Locate>("obstacle");
    return make("avoid_obstacle", {{"shaft_variable", "shaft"s},
                                   {"obstacle_variable", "obstacle"s},
                                   {"min_sphere", 0.30},
                                   {"max_sphere", 0.80},
                                   {"max_repulsion", 100.0},
                                   {"result", "result"s}});
  }
  /// The push along y from an obstacle straight ahead.
  double push_at(double distance_m, double radius_m = 0) {
    const auto avoid = schema();
    locate("obstacle", {0, distance_m}, radius_m);
    const Vec2 force = run(*avoid);
    EXPECT_NEAR(force.x(), 0, kTolerance);
    return -force.y();
  }
};

TEST_F(AvoidObstacleTest, IsGreatestInsideMinSphere) {
  EXPECT_NEAR(push_at(0.10), 100, kTolerance);
  EXPECT_NEAR(push_at(0.30 - kEdgeStep_m), 100, kTolerance);
  EXPECT_NEAR(push_at(0.30), 100, kTolerance);
}

TEST_F(AvoidObstacleTest, FallsLinearlyToMaxSphere) {
  EXPECT_NEAR(push_at(0.30 + kEdgeStep_m), 100 * (0.50 - kEdgeStep_m) / 0.50, kTolerance);
  EXPECT_NEAR(push_at(0.55), 50, kTolerance);
  EXPECT_NEAR(push_at(0.80 - kEdgeStep_m), 100 * kEdgeStep_m / 0.50, kTolerance);
  EXPECT_EQ(push_at(0.80), 0);
  EXPECT_EQ(push_at(0.80 + kEdgeStep_m), 0);
  EXPECT_EQ(push_at(5), 0);
}

TEST_F(AvoidObstacleTest, CountsFromTheObstaclesSurface) {
  EXPECT_NEAR(push_at(0.75, 0.20), 50, kTolerance);
  EXPECT_NEAR(push_at(0.50, 0.20), 100, kTolerance);
}

TEST_F(AvoidObstacleTest, BacksOutOfAnObstaclesVeryCentre) {
  EXPECT_NEAR(push_at(0), 100, kTolerance);
}

TEST_F(AvoidObstacleTest, PushesAwayInTheRobotsOwnFrame) {
  const auto avoid = schema();
  shaft().value.pose = {{1, 1}, 0};  // faces along x: the obstacle is on its left
  locate("obstacle", {1, 1.2});
  expect_near(run(*avoid), {100, 0});
}

TEST_F(AvoidObstacleTest, IsSilentWhileAnInputIsInvalidAndCarriesTheCertaintyOfItsSource) {
  const auto avoid = schema();
  expect_silence(*avoid);
  locate("obstacle", {0, 0.5}, 0, 0.25);
  avoid->run(tick);
  EXPECT_NEAR(result().reliability.certainty, 0.25, kTolerance);
  shaft().reset(tick.now);
  expect_silence(*avoid);
  shaft().mark_written(1, tick.now, tick.number);
  advance(20);
  expect_silence(*avoid);  // 0.25 has faded after 15 s
}

class AvoidRobotTest : public ForceTest {
 protected:
  double push_at(double distance_m, double radius_m = 0) {
    locate("robot", {0, distance_m}, radius_m);
    const auto avoid = make("avoid_robot", {{"shaft_variable", "shaft"s},
                                            {"robot_variable", "robot"s},
                                            {"min_sphere", 0.5},
                                            {"max_sphere", 1.5},
                                            {"max_repulsion", 100.0},
                                            {"result", "result"s}});
    return -run(*avoid).y();
  }
};

TEST_F(AvoidRobotTest, IsInfiniteUpToMinThenFallsFromOneToZero) {
  EXPECT_NEAR(push_at(0), 100, kTolerance);
  EXPECT_NEAR(push_at(0.5 - kEdgeStep_m), 100, kTolerance);
  EXPECT_NEAR(push_at(0.5), 100, kTolerance);
  EXPECT_NEAR(push_at(0.5 + kEdgeStep_m), 1 - kEdgeStep_m, kTolerance);
  EXPECT_NEAR(push_at(1.0), 0.5, kTolerance);
  EXPECT_NEAR(push_at(1.5 - kEdgeStep_m), kEdgeStep_m, kTolerance);
  EXPECT_EQ(push_at(1.5), 0);
  EXPECT_EQ(push_at(1.5 + kEdgeStep_m), 0);
}

TEST_F(AvoidRobotTest, CountsFromCentreToCentre) {
  EXPECT_NEAR(push_at(1.0, 0.25), 0.5, kTolerance);
}

TEST_F(AvoidRobotTest, IsSilentWithoutARobot) {
  variable<Locate>("robot");
  const auto avoid =
      make("avoid_robot",
           {{"shaft_variable", "shaft"s}, {"robot_variable", "robot"s}, {"result", "result"s}});
  expect_silence(*avoid);
}

class SwirlTest : public ForceTest {
 protected:
  Vec2 force_from(Vec2 obstacle_m) {
    locate("obstacle", obstacle_m);
    const auto swirl = make("swirl", {{"shaft_variable", "shaft"s},
                                      {"obstacle_variable", "obstacle"s},
                                      {"min_sphere", 0.30},
                                      {"max_sphere", 0.80},
                                      {"max_repulsion", 1.0},
                                      {"result", "result"s}});
    return run(*swirl);
  }
};

TEST_F(SwirlTest, HasTheMagnitudeOfAvoid) {
  for (const double distance : {0.0, 0.3 - kEdgeStep_m, 0.3}) {
    EXPECT_NEAR(force_from({0, distance}).norm(), 1, kTolerance);
  }
  EXPECT_NEAR(force_from({0, 0.3 + kEdgeStep_m}).norm(), (0.5 - kEdgeStep_m) / 0.5, kTolerance);
  EXPECT_NEAR(force_from({0, 0.8 - kEdgeStep_m}).norm(), kEdgeStep_m / 0.5, kTolerance);
  EXPECT_EQ(force_from({0, 0.8}).norm(), 0);
  EXPECT_EQ(force_from({0, 0.8 + kEdgeStep_m}).norm(), 0);
}

TEST_F(SwirlTest, PassesOnTheSideAwayFromTheObstacle) {
  expect_near(force_from({0, 0.2}), {1, 0});   // ahead: to the right
  expect_near(force_from({-0.2, 0}), {0, 1});  // left: onwards
  expect_near(force_from({0.2, 0}), {0, 1});   // right: onwards
  expect_near(force_from(0.2 * unit_vector(kPi / 2 + 0.1)), unit_vector(0.1));
  expect_near(force_from(0.2 * unit_vector(kPi / 2 - 0.1)), unit_vector(kPi - 0.1));
}

TEST_F(SwirlTest, IsSilentWithoutAnObstacle) {
  variable<Locate>("obstacle");
  const auto swirl = make(
      "swirl",
      {{"shaft_variable", "shaft"s}, {"obstacle_variable", "obstacle"s}, {"result", "result"s}});
  expect_silence(*swirl);
}

}  // namespace
}  // namespace galilean::robot
