// SPDX-License-Identifier: BSD-3-Clause
// Random programs under random inputs, orders, swaps and faults: run again, no bit differs, from
// the first tick on and from each memory.
#include "tests/robot/executive/random_robot_program.h"
#include "tests/robot/rerun/live_robot.h"

namespace galilean::robot {
namespace {

/// A robot that all kinds of things happen to.
class PlaguedRobot {
 public:
  explicit PlaguedRobot(std::uint64_t seed) : programs_(seed) {
    live.recorder.memory_each = 15;
    load();
  }
  ~PlaguedRobot() { journal.clear(); }

  void tick() {
    disturb_devices();
    if (programs_.chance(8)) order();
    if (programs_.chance(12)) load();
    live.clock.advance(std::chrono::microseconds(programs_.below(3000)));
    live.stopwatch.each = std::chrono::milliseconds(programs_.chance(6) ? 60 : 3);
    live.tick();
    journal.clear();
  }

  LiveRobot live;

 private:
  void load() {
    const auto program = program_of(programs_.draw("a program"));
    static_cast<void>(live.executive.load(
        program, {.length = std::chrono::milliseconds(50 * programs_.below(30)),
                  .most_transitions_per_s = static_cast<int>(1 + programs_.below(20))}));
  }

  void disturb_devices() {
    live.board.bumpers = programs_.chance(3) ? static_cast<std::uint8_t>(programs_.below(256)) : 0;
    live.board.beam_broken = programs_.chance(4);
    live.board.gripper_closed = programs_.chance(4);
    live.board.left_travel_m += programs_.below(100) * 0.0007;
    live.board.right_travel_m += programs_.below(100) * 0.0007;
    live.board.left_speed_mps = programs_.below(100) * 0.003;
    if (programs_.chance(40)) ++live.board.epoch;
    live.answers = !programs_.chance(30);
    if (programs_.chance(2)) take_picture();
  }

  void take_picture() {
    Frame& frame = live.devices.camera.picture();
    ++frame.number;
    frame.captured = live.clock.now();
    frame.rgb.fill(static_cast<std::uint8_t>(90 + programs_.below(60)));
    const std::uint32_t top = programs_.below(150), left = programs_.below(300);
    for (std::uint32_t row = top; row < top + 30; ++row)
      for (std::uint32_t column = left; column < left + 25; ++column)
        frame.rgb[3 * (row * Frame::kWidth + column) + programs_.below(3)] = 250;
  }

  void order() {
    switch (programs_.below(9)) {
      case 0:
        return live.executive.hold();
      case 1:
      case 2:
        return live.executive.resume();
      case 3:
        return static_cast<void>(live.executive.step());
      case 4:
        return static_cast<void>(live.executive.stop_with_team());
      case 5:
        return live.executive.push_bumper(static_cast<int>(programs_.below(8)));
      case 6:
        return programs_.chance(3) ? live.executive.decommission() : live.executive.commission();
      case 7:
        return static_cast<void>(live.executive.roll_back(live.executive.running(), "no reason"));
      default:
        return set_break_point();
    }
  }

  void set_break_point() {
    const std::string state = live.executive.present_state();
    if (state.empty()) return;
    const auto kind = static_cast<BreakKind>(programs_.below(3));
    static_cast<void>(live.executive.breaks().set({{{state, ""}, kind}}));
    if (programs_.chance(2))
      static_cast<void>(live.executive.breaks().let_through({{state, ""}}, state));
    if (programs_.chance(3)) live.executive.breaks().clear();
  }

  RandomRobotProgram programs_;
};

TEST(RerunProperty, WhateverHappensARunIsTheSame) {
  std::size_t from_memories = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    PlaguedRobot robot(seed);
    for (int i = 0; i < 150; ++i) robot.tick();
    expect_same(robot.live);
    from_memories += expect_same_from_memories(robot.live);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(from_memories, 100U);
}

}  // namespace
}  // namespace galilean::robot
