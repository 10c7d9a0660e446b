// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/motor/force_test.h"

namespace galilean::robot {
namespace {

class MoveToGoalTest : public ForceTest {
 protected:
  std::unique_ptr<Schema> schema() {
    variable<Locate>("goal");
    return make("move_to_goal", {{"shaft_variable", "shaft"s},
                                 {"goal_variable", "goal"s},
                                 {"success_radius", 0.2},
                                 {"result", "result"s}});
  }
  Vec2 force_to(Vec2 goal_m) {
    locate("goal", goal_m);
    return run(*schema());
  }
};

TEST_F(MoveToGoalTest, IsAUnitVectorOutsideTheSuccessRadius) {
  expect_near(force_to({0, 0}), {0, 0});
  expect_near(force_to({0, 0.2 - kEdgeStep_m}), {0, 0});
  expect_near(force_to({0, 0.2}), {0, 0});
  expect_near(force_to({0, 0.2 + kEdgeStep_m}), {0, 1});
  expect_near(force_to({-3, 4}), {-0.6, 0.8});
}

TEST_F(MoveToGoalTest, PointsInTheRobotsOwnFrame) {
  shaft().value.pose = {{1, 0}, 0};
  expect_near(force_to({3, 0}), {0, 1});
  expect_near(force_to({1, 5}), {-1, 0});
}

TEST_F(MoveToGoalTest, IsSilentWhileTheGoalIsInvalid) {
  const auto schema_ = schema();
  expect_silence(*schema_);
  locate("goal", {0, 1}, 0, 0.5);
  run(*schema_);
  EXPECT_NEAR(result().reliability.certainty, 0.5 - 0.05 / 60, kTolerance);
  variable<Locate>("goal").reset(tick.now);
  expect_silence(*schema_);
}

class GuardedGoalTest : public ForceTest {
 protected:
  double pull_at(double distance_m) {
    locate("goal", {0, distance_m});
    return run(*make("guarded_goal", {{"shaft_variable", "shaft"s},
                                      {"goal_variable", "goal"s},
                                      {"drop_radius", 0.4},
                                      {"dead_radius", 0.1},
                                      {"result", "result"s}}))
        .y();
  }
};

TEST_F(GuardedGoalTest, FallsLinearlyFromDropToDeadRadius) {
  EXPECT_EQ(pull_at(0), 0);
  EXPECT_EQ(pull_at(0.1 - kEdgeStep_m), 0);
  EXPECT_EQ(pull_at(0.1), 0);
  EXPECT_NEAR(pull_at(0.1 + kEdgeStep_m), kEdgeStep_m / 0.3, kTolerance);
  EXPECT_NEAR(pull_at(0.25), 0.5, kTolerance);
  EXPECT_NEAR(pull_at(0.4 - kEdgeStep_m), (0.3 - kEdgeStep_m) / 0.3, kTolerance);
  EXPECT_NEAR(pull_at(0.4), 1, kTolerance);
  EXPECT_NEAR(pull_at(0.4 + kEdgeStep_m), 1, kTolerance);
  EXPECT_NEAR(pull_at(9), 1, kTolerance);
}

TEST_F(GuardedGoalTest, IsSilentWithoutAGoal) {
  variable<Locate>("goal");
  const auto schema =
      make("guarded_goal",
           {{"shaft_variable", "shaft"s}, {"goal_variable", "goal"s}, {"result", "result"s}});
  expect_silence(*schema);
}

/// The dock is in the origin and entered along +y: the approach line is the negative y axis.
class DockTest : public ForceTest {
 protected:
  static constexpr double kCone = kPi / 6;

  DockTest() {
    locate("dock", {0, 0});
    schema_ = make("dock", {{"shaft_variable", "shaft"s},
                            {"dock_variable", "dock"s},
                            {"approach_heading", kPi / 2},
                            {"controlled_radius", 1.0},
                            {"cone", kCone},
                            {"stop_radius", 0.05},
                            {"result", "result"s}});
  }
  /// Robot `distance_m` from the dock, `phi` counter-clockwise from the approach line.
  static Vec2 place(double distance_m, double phi) {
    return distance_m * unit_vector(-kPi / 2 + phi);
  }
  Vec2 force_at(double distance_m, double phi) {
    shaft().value.pose = {place(distance_m, phi), kPi / 2};
    return run(*schema_);
  }
  static Vec2 towards(double phi) { return -place(1, phi); }
  /// Along the circle, back to the approach line from a positive phi.
  static Vec2 clockwise(double phi) { return rotated(place(1, phi), -kPi / 2); }

  std::unique_ptr<Schema> schema_;
};

TEST_F(DockTest, IsBallisticFarAway) {
  expect_near(force_at(1 + kEdgeStep_m, 1.0), towards(1.0));
  expect_near(force_at(4, 0), {0, 1});
}

TEST_F(DockTest, AddsATangentialPartInTheControlledZone) {
  expect_near(force_at(1, 0), {0, 1});
  expect_near(force_at(1 - kEdgeStep_m, 0.2), towards(0.2) + clockwise(0.2) * (0.2 / kCone));
  expect_near(force_at(0.5, -0.2), towards(-0.2) - clockwise(-0.2) * (0.2 / kCone));
}

TEST_F(DockTest, IsFullyTangentialOutsideTheCone) {
  const double inside = kCone - 1e-7;
  const double outside = kCone + 1e-7;
  expect_near(force_at(0.5, inside), towards(inside) + clockwise(inside) * (inside / kCone));
  expect_near(force_at(0.5, outside), towards(outside) * 0.5 + clockwise(outside));
  expect_near(force_at(0.5, -2), towards(-2) * 0.5 - clockwise(-2));
}

TEST_F(DockTest, StopsWithinTheStopRadius) {
  expect_near(force_at(0.05 + kEdgeStep_m, 0), {0, 1});
  expect_near(force_at(0.05 - kEdgeStep_m, 0), {0, 0});
  expect_near(force_at(0, 0), {0, 0});
}

TEST_F(DockTest, IsSilentWithoutADock) {
  variable<Locate>("dock").reset(tick.now);
  expect_silence(*schema_);
}

}  // namespace
}  // namespace galilean::robot
