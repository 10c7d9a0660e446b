// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/perceptual/vision_test.h"

namespace galilean::robot {
namespace {

class TargetMemoryTest : public VisionTest {
 protected:
  TargetMemoryTest() {
    forget_target(0.033);
    finder_ = detector({{"threshold", 60.0}, {"switch_distance", 0.30}, {"miss_penalty", 0.1}});
  }
  void show_cans(std::vector<Cylinder> cans) { show({.cylinders = std::move(cans)}, *finder_); }
  void stand(Vec2 position_m, double heading_rad = kPi / 2) {
    shaft().value.pose = {position_m, heading_rad};
  }
  [[nodiscard]] double off(Vec2 expected_m) {
    return (target().value.position_m - expected_m).norm();
  }
  [[nodiscard]] double certainty() { return target().certainty_at(tick.now); }

  std::unique_ptr<Schema> finder_;
};

TEST_F(TargetMemoryTest, PrefersTheNearest) {
  show_cans({can({0.5, 2.0}), can({-0.3, 1.0})});
  EXPECT_LT(off({-0.3, 1.0}), 0.05);
}

TEST_F(TargetMemoryTest, DoesNotJumpBetweenTwoEquallyNear) {
  show_cans({can({-0.5, 1.40}), can({0.5, 1.60})});
  EXPECT_LT(off({-0.5, 1.40}), 0.1);
  for (int i = 0; i < 5; ++i) {
    show_cans({can({-0.5, 1.45}), can({0.5, 1.30})});
    EXPECT_LT(off({-0.5, 1.45}), 0.1);
  }
  show_cans({can({-0.5, 1.45}), can({0.5, 0.9})});
  EXPECT_LT(off({0.5, 0.9}), 0.1);
}

TEST_F(TargetMemoryTest, RemembersWhatIsOutOfViewUntilSomethingNearerOrSurerIsSeen) {
  show_cans({can({0, 1.0})});
  stand({0, 0}, -kPi / 2);
  show_cans({can({0, 2.5})});
  EXPECT_LT(off({0, 1.0}), 0.05);
  show_cans({can({0, 0.7})});
  EXPECT_LT(off({0, -0.7}), 0.05);
}

TEST_F(TargetMemoryTest, LetsAFadedMemoryGiveWayToWhatIsSurer) {
  show_cans({can({0, 1.0})});
  stand({0, 0}, -kPi / 2);
  advance(30);
  shaft().mark_written(1, tick.now, tick.number);
  show_cans({can({0, 2.0})});
  EXPECT_LT(off({0, -2.0}), 0.2);
}

TEST_F(TargetMemoryTest, LosesWhatIsNoLongerWhereItWas) {
  show_cans({can({0, 1.0})});
  const double seen = certainty();
  show_cans({});
  EXPECT_NEAR(certainty(), seen - 0.1 - 0.1 / 60, 1e-6);
  for (int i = 0; i < 10; ++i) show_cans({});
  EXPECT_FALSE(target().valid_at(tick.now));
}

TEST_F(TargetMemoryTest, FadesWithinAMinuteOutOfView) {
  show_cans({can({0, 1.0})});
  stand({0, 0}, -kPi / 2);
  for (int i = 0; i < 10; ++i) show_cans({});
  EXPECT_GT(certainty(), 0.9);
  advance(60);
  EXPECT_FALSE(target().valid_at(tick.now));
}

TEST_F(TargetMemoryTest, CarriesTheFinalMoveByMemory) {
  const Vec2 at(0, 0.9);
  show_cans({can(at)});
  for (double y = 0; y < 0.62; y += 0.03) {  // until the can stands in the gripper
    stand({0, y});
    show_cans({can(at - Vec2(0, y))});
    EXPECT_LT(off(at), 0.0254) << "from " << 0.9 - y << " m";
    EXPECT_GT(certainty(), 0.8) << "from " << 0.9 - y << " m";
  }
}

TEST_F(TargetMemoryTest, TakesTheNearestVisibleFloorForWhatAppearsRightInFront) {
  show_cans({can({0, 0.35})});
  ASSERT_TRUE(target().valid_at(tick.now));
  EXPECT_LT(off({0, 0.35}), 0.20);
  EXPECT_GT(target().value.covariance_m2(1, 1), 0.01);
  EXPECT_LT(certainty(), 0.6);
}

}  // namespace
}  // namespace galilean::robot
