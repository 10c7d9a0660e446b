// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

using testing::ElementsAre;

constexpr const char* kTwoStates = R"(
variables:
  bits: name: "bumpers"
end
perceptual_schemas:
  bumper_scanner: name: "scan" bits_variable: "bumpers" end
  note: name: "p1" word: "p1" end
  note: name: "p2" word: "p2" end
  note: name: "p3" word: "p3" end
end
motor_schemas:
  note_motor: name: "m1" word: "m1" end
  note_motor: name: "m2" word: "m2" end
end
states:
  state: name: "one"
    perceptual_schemas: "p2" "scan" "p1" end
    motor_schemas: "m1" end
    condition: bits_variable: "bumpers" bit_index: 0 bit_value: 1 new_state: "two" end
  end
  state: name: "two"
    perceptual_schemas: "p3" "scan" end
    motor_schemas: "m2" "m1" end
    condition: bits_variable: "bumpers" bit_index: 0 bit_value: 1 new_state: "one" end
  end
end
)";

TEST(ShortText, IsCutWhereACharacterEnds) {
  const std::string letters(126, 'a');
  EXPECT_EQ(ShortText(letters + "b").view(), letters + "b");
  EXPECT_EQ(ShortText(letters + "é").view(), letters);
  EXPECT_EQ(ShortText(letters + "木 and more").view(), letters);
}

TEST(Tick, PerceivesInListedOrderThenSequencesThenActsInTheNewState) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(kTwoStates));
  robot.tick();
  EXPECT_THAT(journal, ElementsAre("+p2", "+p1", "+m1", "p2", "p1", "m1"));
  journal.clear();
  robot.press(0);
  robot.tick();
  EXPECT_THAT(journal, ElementsAre("p2", "p1", "+p3", "+m2", "+m1", "m2", "m1"));
  EXPECT_EQ(robot.state(), "two");
}

TEST(Tick, ChangesTheStateAtMostOnce) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(kTwoStates));
  robot.press(0);
  robot.tick();
  EXPECT_EQ(robot.state(), "two");
  robot.tick();
  EXPECT_EQ(robot.state(), "one");
  EXPECT_EQ(robot.executive->transitions(), 2U);
  EXPECT_EQ(robot.executive->time_in_state(), Duration::zero());
}

TEST(Tick, OneThatBeginsLateByAWholePeriodIsAnOverrun) {
  class Overruns final : public TickObserver {
   public:
    void on_event(const Event&) noexcept override {}
    void on_tick(const TickView& view) noexcept override { count = view.overruns; }
    std::uint32_t count = 0;
  } overruns;
  TestRobot robot(1, {&overruns});
  ASSERT_TRUE(robot.load(kTwoStates));
  robot.tick(100);
  EXPECT_EQ(overruns.count, 0U) << "no tick missed";
  robot.clock.advance(std::chrono::milliseconds(49));
  robot.tick();
  EXPECT_EQ(overruns.count, 0U) << "late by less than a period";
  robot.clock.advance(std::chrono::milliseconds(50));
  robot.tick();
  EXPECT_EQ(overruns.count, 1U);
  robot.tick(10);
  EXPECT_EQ(overruns.count, 1U);
}

TEST(Tick, WithoutAProgramStandsStill) {
  TestRobot robot;
  robot.tick(3);
  EXPECT_EQ(robot.state(), "");
  EXPECT_EQ(robot.drive.commands, 0);
}

TEST(Tick, ATransitionTellsWhichConditionOfWhichStateFired) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(kTwoStates));
  robot.tick(4);
  robot.press(0);
  robot.tick();
  const Event* transition = robot.events.last(Event::Kind::kTransition);
  ASSERT_NE(transition, nullptr);
  EXPECT_EQ(transition->number, 1U);
  EXPECT_EQ(transition->tick, 5U);
  EXPECT_EQ(transition->time, robot.now());
  EXPECT_EQ(transition->from_state, 0U);
  EXPECT_EQ(transition->to_state, 1U);
  EXPECT_EQ(transition->condition, 0U);
}

constexpr const char* kTwoForces = R"(
variables:
  bits: name: "bumpers"
  force: name: "steady" value: <0, 0.25> status: "valid"
  force: name: "left"
  force: name: "right"
  force: name: "total"
end
perceptual_schemas:
  bumper_scanner: name: "scan" bits_variable: "bumpers" end
  write_all: name: "push_left" force_variable: "left" end
  write_all: name: "push_right" force_variable: "right" end
end
motor_schemas:
  combine_forces: name: "combine" inputs: "steady" "left" "right" gains: 1 0.1 0.01
    max_length: 100 result: "total" end
end
states:
  state: name: "both"
    perceptual_schemas: "scan" "push_left" "push_right" end
    motor_schemas: "combine" end
    condition: bits_variable: "bumpers" bit_index: 0 bit_value: 1 new_state: "one" end
  end
  state: name: "one"
    perceptual_schemas: "push_left" end
    motor_schemas: "combine" end
  end
end
)";

TEST(Tick, AForceWhoseSchemaDidNotRunDoesNotCount) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(kTwoForces));
  robot.tick();
  EXPECT_DOUBLE_EQ(robot.variable<Force>("total").value.value.x(), 0.11 * 1);
  robot.press(0);
  robot.tick();
  robot.tick();
  EXPECT_DOUBLE_EQ(robot.variable<Force>("total").value.value.x(), 0.1 * 3);
  EXPECT_DOUBLE_EQ(robot.variable<Force>("total").value.value.y(), 0.25);
  EXPECT_TRUE(robot.variable<Force>("right").valid_at(robot.now()));
}

constexpr const char* kFails = R"(
variables:
  bits: name: "bumpers"
  bits: name: "broken"
end
perceptual_schemas:
  thrower: name: "thrower" after: 2 bits_variable: "broken" end
  note: name: "sibling" word: "sibling" end
end
states:
  state: name: "only" perceptual_schemas: "thrower" "sibling" end end
end
)";

TEST(Tick, ASchemaThatThrowsIsSwitchedOffAndItsSiblingsRunOn) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(kFails));
  robot.tick(2);
  EXPECT_TRUE(robot.variable<Bits>("broken").valid_at(robot.now()));
  robot.tick(3);
  EXPECT_FALSE(robot.variable<Bits>("broken").valid_at(robot.now()));
  EXPECT_EQ(std::ranges::count(journal, "sibling"), 5);
  EXPECT_EQ(robot.events.count(Event::Kind::kSchemaFailed), 1);
  const Event* failure = robot.events.last(Event::Kind::kSchemaFailed);
  EXPECT_EQ(failure->tick, 3U);
  EXPECT_EQ(failure->text.view(), "the lens broke");
  EXPECT_EQ(robot.executive->description(failure->program)->schemas[failure->schema], "thrower");
}

TEST(Tick, APushedBumperIsPressedForThreeTenthsOfASecond) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(kTwoForces));
  robot.tick();
  robot.executive->push_bumper(3);
  robot.executive->push_bumper(99);
  robot.press(5);
  robot.tick();
  EXPECT_EQ(robot.variable<Bits>("bumpers").value.value, 1U << 3 | 1U << 5);
  robot.tick(5);
  EXPECT_EQ(robot.variable<Bits>("bumpers").value.value, 1U << 3 | 1U << 5);
  robot.tick();
  EXPECT_EQ(robot.variable<Bits>("bumpers").value.value, 1U << 5);
}

TEST(Tick, APerceptualAndAMotorSchemaMayShareAName) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(R"(
variables: bits: name: "bumpers" end
perceptual_schemas: bumper_scanner: name: "grip" bits_variable: "bumpers" end end
motor_schemas: move_gripper: name: "grip" command: "close" end end
state: name: "s" perceptual_schemas: "grip" end motor_schemas: "grip" end end
)"));
  robot.press(2);
  robot.tick();
  EXPECT_EQ(robot.variable<Bits>("bumpers").value.value, 1U << 2);
  EXPECT_EQ(robot.port.gripper, GripperCommand::kClose);
}

}  // namespace
}  // namespace galilean::robot
