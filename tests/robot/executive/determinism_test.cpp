// SPDX-License-Identifier: BSD-3-Clause
#include <thread>

#include "robot/executive/snapshot.h"
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

TEST(Threads, ProgramsAreBuiltReadAndDestroyedBesideTheControlLoop) {
  SnapshotTap tap;
  TestRobot robot(1, {&tap});
  robot.events.events.reserve(100000);
  const auto wander = shipped_program("office_cleanup.bhdl");
  const auto spin = shipped_program("sit_and_spin.bhdl");
  ASSERT_TRUE(robot.executive->load(wander));
  std::atomic<bool> done{false};
  std::jthread control([&] {
    while (!done) robot.tick();
  });
  std::uint64_t last_tick = 0;
  int swaps = 0;
  for (int i = 0; i < 40; ++i) {
    while (robot.executive->waiting()) std::this_thread::yield();
    ASSERT_TRUE(robot.executive->load(i % 2 ? wander : spin));
    while (const auto event = tap.next_event()) {
      swaps += event->kind == Event::Kind::kSwapped;
      EXPECT_NE(robot.executive->description(event->program), nullptr);
    }
    if (!tap.take()) continue;
    const Snapshot& snapshot = tap.newest();
    EXPECT_GT(snapshot.tick, last_tick);
    last_tick = snapshot.tick;
    const auto description = robot.executive->description(snapshot.program);
    ASSERT_NE(description, nullptr);
    EXPECT_EQ(snapshot.variables.size(), description->variables.size());
    EXPECT_LT(snapshot.state, description->program.states.size());
  }
  done = true;
  EXPECT_GT(swaps, 20);
}

}  // namespace
}  // namespace galilean::robot
