// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

/// Counts its ticks in `count`, and does in its one state what `schema` says.
std::string counting_program(const std::string& schema, const std::string& state = "only") {
  return R"(
input_devices: frame_grabber: end end
variables: bits: name: "count" bits: name: "bumpers" end
perceptual_schemas:
  count_bits: name: "counter" bits_variable: "count" end
  bumper_scanner: name: "scan" bits_variable: "bumpers" end
)" + schema +
         R"(
end
motor_schemas: call: name: "call" end end
states:
  state: name: ")" +
         state + R"(" perceptual_schemas: "counter" "scan" "it" end motor_schemas: "call" end
    condition: bits_variable: "bumpers" bit_index: 7 bit_value: 1 new_state: ")" +
         state + R"(" end
  end
end
)";
}
const std::string kHarmless = "note: name: \"it\" end";
const std::string kThrows = "thrower: name: \"it\" after: 5 end";

class ProbationTest : public testing::Test {
 protected:
  ProbationTest() {
    on_call = [](const Tick&) {};
    EXPECT_TRUE(robot.load(counting_program(kHarmless)));
    robot.tick(10);
  }
  ~ProbationTest() override { on_call = nullptr; }

  void swap(const std::string& text) {
    ASSERT_TRUE(robot.load(text));
    robot.tick();
  }
  [[nodiscard]] ProgramId running() const { return robot.executive->program()->description->id; }
  void expect_rolled_back(Fault fault, ProgramId to = 1) {
    const Event* event = robot.events.last(Event::Kind::kRolledBack);
    ASSERT_NE(event, nullptr);
    EXPECT_EQ(event->fault, fault);
    EXPECT_EQ(event->program, to);
    EXPECT_EQ(running(), to);
    EXPECT_FALSE(robot.events.in_probation);
  }

  TestRobot robot;
};

TEST_F(ProbationTest, TheFirstProgramIsInNone) {
  EXPECT_FALSE(robot.events.in_probation);
  EXPECT_EQ(robot.events.count(Event::Kind::kStarted), 1);
}

TEST_F(ProbationTest, AProgramThatWorksIsConfirmedAfterTenSeconds) {
  swap(counting_program(kHarmless));
  robot.tick(199);
  EXPECT_TRUE(robot.events.in_probation);
  robot.tick();
  EXPECT_FALSE(robot.events.in_probation);
  EXPECT_EQ(robot.events.count(Event::Kind::kConfirmed), 1);
  EXPECT_EQ(running(), 2U);
}

TEST_F(ProbationTest, AThrownSchemaRollsBackWithinOneTick) {
  swap(counting_program(kThrows));
  robot.tick(4);
  EXPECT_EQ(running(), 2U);
  robot.tick();
  const std::uint32_t count = robot.variable<Bits>("count").value.value;
  EXPECT_EQ(robot.events.count(Event::Kind::kSchemaFailed), 1);
  robot.tick();
  expect_rolled_back(Fault::kSchemaThrew);
  const Event* event = robot.events.last(Event::Kind::kRolledBack);
  EXPECT_EQ(event->tick, robot.events.last(Event::Kind::kSchemaFailed)->tick + 1);
  EXPECT_EQ(event->text.view(), "the lens broke");
  EXPECT_EQ(robot.variable<Bits>("count").value.value, count + 1) << "variables come back too";
}

TEST_F(ProbationTest, AfterProbationAThrownSchemaIsSwitchedOffOnly) {
  swap(counting_program("thrower: name: \"it\" after: 300 end"));
  robot.tick(310);
  EXPECT_EQ(robot.events.count(Event::Kind::kSchemaFailed), 1);
  EXPECT_EQ(robot.events.count(Event::Kind::kRolledBack), 0);
  EXPECT_EQ(running(), 2U);
}

TEST_F(ProbationTest, ThreeLongTicksInARowRollBack) {
  on_call = [this](const Tick&) { robot.stopwatch.advance(std::chrono::milliseconds(51)); };
  swap(counting_program(kHarmless));
  robot.tick();
  on_call = [](const Tick&) {};
  robot.tick(3);
  EXPECT_EQ(running(), 2U) << "two are none too many";
  on_call = [this](const Tick&) { robot.stopwatch.advance(std::chrono::milliseconds(51)); };
  robot.tick(3);
  on_call = [](const Tick&) {};
  robot.tick();
  expect_rolled_back(Fault::kOverran);
}

TEST_F(ProbationTest, ADeviceThatIsLostRollsBack) {
  swap(counting_program(kHarmless));
  robot.camera.answers = false;
  robot.tick(2);
  expect_rolled_back(Fault::kDeviceLost);
  EXPECT_EQ(robot.events.last(Event::Kind::kRolledBack)->text.view(), "frame_grabber");
}

TEST_F(ProbationTest, ADeviceThatWasLostBeforeIsNoReproach) {
  robot.camera.answers = false;
  robot.tick();
  swap(counting_program(kHarmless));
  robot.tick(5);
  EXPECT_EQ(running(), 2U);
}

TEST_F(ProbationTest, MoreThanTenTransitionsASecondRollBack) {
  swap(counting_program(kHarmless));
  robot.press(7);
  robot.tick(10);
  EXPECT_EQ(running(), 2U);
  robot.tick(2);
  expect_rolled_back(Fault::kThrashed);
}

TEST_F(ProbationTest, ARollbackGoesToTheLastThatProvedItself) {
  swap(counting_program(kHarmless));
  robot.tick(5);
  swap(counting_program(kThrows));
  robot.tick(10);
  expect_rolled_back(Fault::kSchemaThrew, 1);
  EXPECT_EQ(robot.executive->description(2)->id, 2U);
}

TEST_F(ProbationTest, ARollbackReturnsToTheStateThatWasLeft) {
  swap(counting_program(kThrows, "elsewhere"));
  EXPECT_EQ(robot.state(), "elsewhere");
  robot.tick(6);
  EXPECT_EQ(robot.state(), "only");
  EXPECT_EQ(robot.events.last(Event::Kind::kTransition)->cause, Event::Cause::kRollback);
}

TEST_F(ProbationTest, APushMayBringRulesOfItsOwn) {
  ASSERT_TRUE(
      robot.executive->load(program_of(counting_program(kHarmless)),
                            {.length = std::chrono::seconds(1), .most_transitions_per_s = 3}));
  robot.tick(20);
  EXPECT_TRUE(robot.events.in_probation);
  robot.tick();
  EXPECT_FALSE(robot.events.in_probation);
  ASSERT_TRUE(
      robot.executive->load(program_of(counting_program(kHarmless)),
                            {.length = std::chrono::seconds(1), .most_transitions_per_s = 3}));
  robot.press(7);
  robot.tick(4);
  EXPECT_EQ(running(), 3U);
  robot.tick();
  expect_rolled_back(Fault::kThrashed, 2);
}

TEST(Probation, TheRobotsOwnRulesHoldWhereAPushBringsNone) {
  TestRobot robot(1, {}, {.length = std::chrono::seconds(2)});
  on_call = [](const Tick&) {};
  ASSERT_TRUE(robot.load(counting_program(kHarmless)));
  robot.tick();
  ASSERT_TRUE(robot.load(counting_program(kHarmless)));
  robot.tick(40);
  EXPECT_TRUE(robot.events.in_probation);
  robot.tick();
  EXPECT_FALSE(robot.events.in_probation);
  on_call = nullptr;
}

TEST_F(ProbationTest, AnOrderTakesAProgramOffInTheNextTick) {
  swap(counting_program(kHarmless));
  robot.tick(3);
  EXPECT_TRUE(robot.executive->roll_back(2, "by anna: it circles"));
  robot.tick();
  expect_rolled_back(Fault::kOrdered);
  const Event* event = robot.events.last(Event::Kind::kRolledBack);
  EXPECT_EQ(event->tick, robot.executive->last_tick().number);
  EXPECT_EQ(event->text.view(), "by anna: it circles");
}

TEST_F(ProbationTest, AnOrderTakesAProgramOffThatHasProvenItselfToo) {
  swap(counting_program(kHarmless));
  robot.tick(250);
  EXPECT_FALSE(robot.events.in_probation);
  EXPECT_TRUE(robot.executive->roll_back(2, ""));
  robot.tick();
  expect_rolled_back(Fault::kOrdered);
}

TEST_F(ProbationTest, AnOrderBringsBackWhatRanBeforeEvenIfThatIsUnproven) {
  swap(counting_program(kThrows));
  robot.tick(2);
  swap(counting_program(kHarmless));
  EXPECT_TRUE(robot.executive->roll_back(3, "by anna: back"));
  robot.tick();
  EXPECT_EQ(running(), 2U);
  EXPECT_TRUE(robot.events.in_probation) << "anew";
  EXPECT_TRUE(robot.events.last(Event::Kind::kRolledBack)->in_probation);
  robot.tick(3);
  expect_rolled_back(Fault::kSchemaThrew, 1);
}

TEST_F(ProbationTest, OrdersAgainstTwoUnprovenProgramsLeadToTheLastGoodOne) {
  swap(counting_program(kHarmless));
  swap(counting_program(kHarmless));
  EXPECT_TRUE(robot.executive->roll_back(3, ""));
  robot.tick();
  EXPECT_TRUE(robot.executive->roll_back(2, ""));
  robot.tick();
  expect_rolled_back(Fault::kOrdered, 1);
}

TEST_F(ProbationTest, AnOrderAgainstAProgramThatRunsNoMoreDoesNothing) {
  swap(counting_program(kHarmless));
  swap(counting_program(kHarmless));
  EXPECT_TRUE(robot.executive->roll_back(2, ""));
  robot.tick();
  EXPECT_EQ(running(), 3U);
  robot.tick(250);
  EXPECT_TRUE(robot.executive->roll_back(3, ""));
  robot.tick();
  EXPECT_EQ(running(), 2U) << "which it replaced";
  EXPECT_TRUE(robot.executive->roll_back(2, ""));
  robot.tick();
  EXPECT_TRUE(robot.executive->roll_back(1, "")) << "which nothing ran before";
  robot.tick();
  EXPECT_EQ(running(), 1U);
}

TEST_F(ProbationTest, ManySwapsAndRollbacksInARowLeaveTheRobotAtWork) {
  for (int i = 0; i < 60; ++i) {
    swap(counting_program(i % 3 == 0 ? kThrows : kHarmless));
    robot.tick(i % 7 == 0 ? 250 : i % 5);
    if (i % 4 != 0) continue;
    EXPECT_TRUE(robot.executive->roll_back(running(), ""));
    robot.tick();
  }
  robot.tick(300);
  EXPECT_FALSE(robot.events.in_probation);
  EXPECT_NE(robot.executive->description(running()), nullptr);
}

}  // namespace
}  // namespace galilean::robot
