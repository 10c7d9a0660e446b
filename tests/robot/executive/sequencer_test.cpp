// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

/// One state that tests bit 0 of `bumpers` as `condition` says, and what else it says.
std::string branching_program(const std::string& conditions, const std::string& variables = "") {
  return R"(
variables:
  bits: name: "bumpers"
  bits: name: "flags" value: 5 status: "valid"
  bits: name: "never"
  locate: name: "trash"
)" + variables +
         R"(
end
perceptual_schemas:
  bumper_scanner: name: "scan" bits_variable: "bumpers" bit_index: 0 end
  write_all: name: "see" locate_variable: "trash" end
end
states:
  state: name: "start" perceptual_schemas: "scan" "see" end
)" + conditions +
         R"(
  end
  state: name: "a" end
  state: name: "b" end
end
)";
}

std::string condition(const std::string& variable, int index, int value, const std::string& rest) {
  return "condition: bits_variable: \"" + variable + "\" bit_index: " + std::to_string(index) +
         " bit_value: " + std::to_string(value) + " " + rest + " end\n";
}

TEST(Sequencer, TheFirstConditionInTheTextThatHoldsFires) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(branching_program(condition("flags", 1, 1, "new_state: \"a\"") +
                                           condition("flags", 0, 1, "new_state: \"b\"") +
                                           condition("flags", 2, 1, "new_state: \"a\""))));
  robot.tick();
  EXPECT_EQ(robot.state(), "b");
}

TEST(Sequencer, TellsWhatEveryConditionWasBeforeOneFired) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(branching_program(
      condition("never", 0, 1, "new_state: \"a\"") + condition("flags", 1, 1, "new_state: \"a\"") +
      condition("flags", 0, 1, "bit_update: \"clear\" new_state: \"b\"") +
      condition("flags", 0, 1, "new_state: \"a\""))));
  robot.tick();
  const Event* change = robot.events.last(Event::Kind::kTransition);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->condition, 2U);
  EXPECT_EQ(change->tested.valid, 0b1110U);
  EXPECT_EQ(change->tested.holds, 0b1100U) << "the last one held as well, and came too late";
}

TEST(Sequencer, NoConditionHoldsOnAnInvalidVariable) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(branching_program(condition("never", 0, 0, "new_state: \"a\"") +
                                           condition("never", 0, 1, "new_state: \"b\""))));
  robot.tick(10);
  EXPECT_EQ(robot.state(), "start");
}

TEST(Sequencer, ABitThatIsZeroCanBeWaitedFor) {
  TestRobot robot;
  robot.press(0);
  ASSERT_TRUE(robot.load(branching_program(condition("bumpers", 0, 0, "new_state: \"a\""))));
  robot.tick(3);
  EXPECT_EQ(robot.state(), "start");
  robot.press(0, false);
  robot.tick();
  EXPECT_EQ(robot.state(), "a");
}

struct Update {
  const char* word;
  int tested;
  std::uint32_t value_after;
};

class BitUpdates : public testing::TestWithParam<Update> {};

TEST_P(BitUpdates, ActsOnTheTestedBitAlone) {
  const Update update = GetParam();
  TestRobot robot;
  ASSERT_TRUE(robot.load(branching_program(
      condition("flags", update.tested, update.tested == 1 ? 0 : 1,
                std::string("bit_update: \"") + update.word + "\" new_state: \"a\""))));
  robot.tick();
  EXPECT_EQ(robot.state(), "a");
  EXPECT_EQ(robot.variable<Bits>("flags").value.value, update.value_after);
  EXPECT_DOUBLE_EQ(robot.variable<Bits>("flags").certainty_at(robot.now()), 1);
}

INSTANTIATE_TEST_SUITE_P(All, BitUpdates,
                         testing::Values(Update{"same", 0, 5}, Update{"set", 0, 5},
                                         Update{"clear", 0, 4}, Update{"toggle", 0, 4},
                                         Update{"same", 1, 5}, Update{"set", 1, 7},
                                         Update{"clear", 1, 5}, Update{"toggle", 1, 7}));

TEST(Sequencer, ResetVariablesBecomeInvalidWithoutCertainty) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(branching_program(
      condition("bumpers", 0, 1, "reset_variables: \"trash\" new_state: \"a\""))));
  robot.tick();
  EXPECT_TRUE(robot.variable<Locate>("trash").valid_at(robot.now()));
  robot.press(0);
  robot.tick();
  EXPECT_EQ(robot.state(), "a");
  EXPECT_FALSE(robot.variable<Locate>("trash").valid_at(robot.now()));
  EXPECT_EQ(robot.variable<Locate>("trash").certainty_at(robot.now()), 0);
}

TEST(Sequencer, AnInactiveSchemasVariableStaysAndFades) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(branching_program(condition("bumpers", 0, 1, "new_state: \"a\""))));
  robot.press(0);
  robot.tick();
  robot.tick(20 * 30);
  EXPECT_EQ(robot.variable<Locate>("trash").value.position_m.x(), 1);
  EXPECT_NEAR(robot.variable<Locate>("trash").certainty_at(robot.now()), 0.5, 1e-9);
  robot.tick(20 * 30);
  EXPECT_FALSE(robot.variable<Locate>("trash").valid_at(robot.now()));
}

}  // namespace
}  // namespace galilean::robot
