// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/state_hash.h"
#include "tests/robot/executive/office.h"

namespace galilean::robot {
namespace {

std::uint64_t hash_after_a_minute(std::uint64_t seed, const std::vector<BreakPoint>& points = {}) {
  TestRobot robot(seed);
  EXPECT_TRUE(robot.executive->breaks().set(points));
  paint_office(robot.camera.picture);
  EXPECT_TRUE(robot.executive->load(shipped_program("office_cleanup.bhdl")));
  StateHash hash;
  for (int i = 0; i < 1200; ++i) {
    robot.port.next.bumpers = i % 97 == 0 ? 1 : 0;
    robot.port.next.left_travel_m += robot.drive.last.speed_mps / 20;
    robot.port.next.right_travel_m += robot.drive.last.speed_mps / 20;
    if (i % 2) ++robot.camera.picture.number;
    if (i == 600) {
      EXPECT_TRUE(robot.executive->load(shipped_program("sit_and_spin.bhdl")));
    }
    robot.tick();
    robot.executive->hash_into(hash);
  }
  return hash.value();
}

TEST(Determinism, TheSameSeedGoesTheSameWay) {
  EXPECT_EQ(hash_after_a_minute(3), hash_after_a_minute(3));
}

TEST(Determinism, AnotherSeedGoesAnotherWay) {
  EXPECT_NE(hash_after_a_minute(3), hash_after_a_minute(4));
}

TEST(Determinism, BreakPointsThatAreNotReachedChangeNothing) {
  const std::vector<BreakPoint> points{{{"wander_for_trash", "nowhere"}, BreakKind::kStop},
                                       {{"nowhere", ""}, BreakKind::kLock}};
  EXPECT_EQ(hash_after_a_minute(3, points), hash_after_a_minute(3));
}

}  // namespace
}  // namespace galilean::robot
