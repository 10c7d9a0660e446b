// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/pending_touches.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

/// Io starts at the origin, and faces along x.
class PendingTouchesTest : public testing::Test {
 protected:
  PendingTouchesTest() {
    origins.hear("io");
    report();
  }

  void report() {
    poses.predict("io", in_odom, false, now);
    for (const Gaussian2& touched : touches.take_settled("io", poses, now))
      settled.push_back(touched);
    now += 100ms;
  }
  void drive(double way_m) {
    constexpr double kStep_m = 0.02;
    for (double driven_m = 0; driven_m < way_m; driven_m += kStep_m) {
      in_odom.position_m += kStep_m * unit_vector(in_odom.heading_rad);
      report();
    }
  }
  void lose(double deviation_m) {
    RobotMatrix noise = RobotMatrix::Zero();
    noise.topLeftCorner<2, 2>() = deviation_m * deviation_m * Mat2::Identity();
    joint.inflate(poses.block("io"), noise);
  }
  /// Measures that io stands `off_m` from where it is believed to be.
  void find(const Vec2& off_m) {
    const JointGaussian::Term position{poses.block("io"), Eigen::Matrix<double, 2, 3>::Identity()};
    joint.correct({&position, 1}, off_m, 1e-4 * Mat2::Identity());
  }
  void touch(const Vec2& in_odom_m) { touches.add("io", in_odom_m, poses, now); }

  OdomOrigins origins;
  JointGaussian joint;
  RobotPoses poses{joint, origins};
  PendingTouches touches;
  Pose2 in_odom;
  Time now{1s};
  std::vector<Gaussian2> settled;
};

TEST_F(PendingTouchesTest, AreSettledAtOnceWhereTheRobotKnowsItsPlace) {
  touch({0.27, 0});
  report();
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_LT((settled[0].mean_m - Vec2(0.27, 0)).norm(), 1e-6);
  report();
  EXPECT_EQ(settled.size(), 1U) << "and never again";
}

TEST_F(PendingTouchesTest, WaitForARobotThatIsLost) {
  lose(0.4);
  touch({0.27, 0});
  drive(0.3);
  EXPECT_TRUE(settled.empty());
}

TEST_F(PendingTouchesTest, StandWhereTheRobotMustHaveBeenOnceItKnowsItsPlace) {
  lose(0.4);
  touch({0.27, 0});
  drive(0.3);
  find({0.1, 0.2});
  drive(1);
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_LT((settled[0].mean_m - Vec2(0.37, 0.2)).norm(), 0.02);
  EXPECT_LT(settled[0].covariance_m2.trace(), 2 * 0.1 * 0.1);
}

// The odometer turns further than the robot, and so loses the way back to the touch.
TEST_F(PendingTouchesTest, AreNotKnownBetterByARobotThatFindsItsPlaceFarAway) {
  lose(0.4);
  touch({0.27, 0});
  drive(10);
  find({0.1, 0.2});
  report();
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_GT(settled[0].covariance_m2.trace(), 0.4 * 0.4);
}

TEST_F(PendingTouchesTest, DoNotWaitLongForARobotThatStaysLost) {
  lose(0.4);
  touch({0.27, 0});
  for (Time last = now + PendingTouches::kLongest; now <= last;) report();
  EXPECT_TRUE(settled.empty());
  report();
  EXPECT_EQ(settled.size(), 1U);
}

}  // namespace
}  // namespace galilean::monitor
