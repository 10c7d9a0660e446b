// SPDX-License-Identifier: BSD-3-Clause
// What other threads do to an executive while the control loop ticks. ThreadSanitizer runs it as
// well.
#include <atomic>
#include <thread>

#include "robot/executive/snapshot.h"
#include "tests/robot/executive/branching_robot.h"
#include "tests/robot/executive/office.h"

namespace galilean::robot {
namespace {

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

/// Other threads set, let through and step while the loop ticks.
TEST(Threads, BreakPointsChangeBesideTheControlLoop) {
  SnapshotTap tap;
  BranchingRobot robot({&tap});
  robot.events.events.reserve(1'000'000);
  std::atomic<bool> done{false};
  std::jthread control([&] {
    while (!done && robot.events.events.size() < 900'000)
      robot.go_to(robot.state() == "wander" ? "grab" : "wander");
  });
  Executive& executive = *robot.executive;
  int stops = 0;
  for (int i = 0; i < 2000 || (stops == 0 && i < 1'000'000); ++i) {
    robot.set("", i % 2 ? "grab" : "wander", i % 3 ? BreakKind::kStop : BreakKind::kLock);
    static_cast<void>(executive.breaks().let_through({{"", "grab"}}, executive.present_state()));
    static_cast<void>(executive.step());
    if (i % 5 == 0) executive.breaks().clear();
    while (const auto event = tap.next_event()) stops += event->stopped_by != Hold::kNone;
    std::this_thread::yield();
  }
  done = true;
  control.join();
  EXPECT_GT(stops, 0);
}

}  // namespace
}  // namespace galilean::robot
