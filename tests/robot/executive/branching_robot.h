// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {

/// Returns a program that drives in each of its states. From the first one, bumper 0 leads to
/// "grab" and bumper 1 to "rest"; bumper 2 leads back.
inline std::string branching_text(const std::string& first = "wander") {
  const std::string quoted = "\"" + first + "\"";
  const auto condition = [](int bumper, const std::string& to) {
    return "    condition: bits_variable: \"bumpers\" bit_index: " + std::to_string(bumper) +
           " bit_value: 1 new_state: " + to + " end\n";
  };
  const auto state = [](const std::string& name, const std::string& conditions) {
    return "  state: name: " + name +
           " perceptual_schemas: \"scan\" end motor_schemas: \"ahead\" \"note\" end\n" +
           conditions + "  end\n";
  };
  return R"(
variables: bits: name: "bumpers" end
perceptual_schemas: bumper_scanner: name: "scan" bits_variable: "bumpers" end end
motor_schemas:
  ahead: name: "ahead" speed: 0.2 end
  note_motor: name: "note" end
end
states:
)" + state(quoted, condition(0, "\"grab\"") + condition(1, "\"rest\"")) +
         state("\"grab\"", condition(2, quoted)) + state("\"rest\"", condition(2, quoted)) +
         "end\n";
}

/// A robot that runs this program, and that the test leads through its states.
class BranchingRobot : public TestRobot {
 public:
  explicit BranchingRobot(std::vector<TickObserver*> more = {}) : TestRobot(1, std::move(more)) {
    EXPECT_TRUE(load(branching_text()));
    tick();
  }
  void set(const std::string& from, const std::string& to, BreakKind kind) {
    EXPECT_TRUE(executive->breaks().set({{{from, to}, kind, "Anna"}}));
  }
  void stop_at(const std::string& from, const std::string& to) { set(from, to, BreakKind::kStop); }
  /// Makes one tick, in which the bumper that leads to `state` is pressed.
  void go_to(const std::string& state) {
    const unsigned bumper = state == "grab" ? 0 : state == "rest" ? 1 : 2;
    press(bumper);
    tick();
    press(bumper, false);
  }
};

}  // namespace galilean::robot
