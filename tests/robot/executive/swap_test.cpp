// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

using testing::ElementsAre;

/// A small program of one's own: what differs between two of them is what a swap is about.
struct Sketch {
  std::vector<std::string> states = {"start"};
  std::string on_swap;
  std::string variables;
  std::string perceptual_schemas;
  std::string listed;  ///< of every state

  [[nodiscard]] std::string text() const {
    std::string made = on_swap.empty() ? "" : "on_swap: " + on_swap + " end\n";
    made += "variables:\n  bits: name: \"count\"\n" + variables + "end\n";
    made += "perceptual_schemas:\n  count_bits: name: \"counter\" bits_variable: \"count\" end\n" +
            perceptual_schemas + "end\nstates:\n";
    for (std::size_t i = 0; i < states.size(); ++i) {
      made += "  state: name: \"" + states[i] + "\" perceptual_schemas: \"counter\" " + listed +
              " end\n    condition: bits_variable: \"count\" bit_index: 31 bit_value: 1 "
              "new_state: \"" +
              states[(i + 1) % states.size()] + "\" end\n  end\n";
    }
    return made + "end\n";
  }
};

TEST(Swap, TheStateStaysIfTheNewProgramHasIt) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(Sketch{.states = {"a", "b"}}.text()));
  robot.tick(5);
  ASSERT_TRUE(robot.load(Sketch{.states = {"b", "a", "c"}}.text()));
  robot.tick();
  EXPECT_EQ(robot.state(), "a");
  EXPECT_EQ(robot.executive->time_in_state(), 5 * std::chrono::milliseconds(50));
  EXPECT_EQ(robot.events.count(Event::Kind::kTransition), 0);
  EXPECT_EQ(robot.events.last(Event::Kind::kSwapped)->tick, 6U);
}

TEST(Swap, ElseOnSwapSaysWhereToGoOn) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(Sketch{.states = {"a", "b"}}.text()));
  robot.tick();
  ASSERT_TRUE(robot.load(Sketch{.states = {"x", "y"}, .on_swap = "\"a\": \"y\""}.text()));
  robot.tick();
  EXPECT_EQ(robot.state(), "y");
  const Event* change = robot.events.last(Event::Kind::kTransition);
  ASSERT_NE(change, nullptr);
  EXPECT_EQ(change->cause, Event::Cause::kSwap);
  EXPECT_NE(change->from_program, change->program);
}

TEST(Swap, ElseItBeginsInItsStartState) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(Sketch{.states = {"a"}}.text()));
  robot.tick();
  ASSERT_TRUE(robot.load(Sketch{.states = {"x", "y"}}.text()));
  robot.tick();
  EXPECT_EQ(robot.state(), "x");
}

TEST(Swap, ANewProgramActivatesItsSchemasInAStateThatStays) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(Sketch{}.text()));
  robot.tick();
  ASSERT_TRUE(robot.load(
      Sketch{.perceptual_schemas = "note: name: \"n\" end\n", .listed = "\"n\""}.text()));
  robot.tick();
  EXPECT_THAT(journal, ElementsAre("+note", "note"));
}

TEST(Swap, AParameterTakesTheValueOfTheNewText) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(
      Sketch{.variables = "force: name: \"back\" value: <0,-1> status: \"valid\"\n"}.text()));
  robot.tick();
  ASSERT_TRUE(robot.load(
      Sketch{.variables = "force: name: \"back\" value: <0,-0.5> status: \"valid\"\n"}.text()));
  robot.tick(20 * 120);
  EXPECT_DOUBLE_EQ(robot.variable<Force>("back").value.value.y(), -0.5);
  EXPECT_DOUBLE_EQ(robot.variable<Force>("back").certainty_at(robot.now()), 1);
}

TEST(Swap, DeadReckoningGoesOnWhereItWas) {
  const std::string shaft = "shaft: name: \"shaft\" position: (100, 0) status: \"valid\"\n";
  TestRobot robot;
  ASSERT_TRUE(robot.load(Sketch{.variables = shaft}.text()));
  robot.tick();
  robot.port.next.left_travel_m = robot.port.next.right_travel_m = 0.5;
  robot.tick();
  ASSERT_TRUE(robot.load(Sketch{.states = {"other"}, .variables = shaft}.text()));
  robot.port.next.left_travel_m = robot.port.next.right_travel_m = 0.75;
  robot.tick();
  EXPECT_DOUBLE_EQ(robot.variable<Shaft>("shaft").value.pose.position_m.x(), 1.75);
  EXPECT_EQ(robot.executive->pose().position_m, Vec2(1.75, 0));
}

TEST(Swap, AVariableOfAnotherTypeIsAnotherVariable) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(Sketch{.variables = "force: name: \"thing\" value: <3,4>\n"}.text()));
  robot.tick();
  const auto before = robot.executive->description(1);
  ASSERT_TRUE(robot.load(Sketch{.variables = "locate: name: \"thing\"\n"}.text()));
  robot.tick();
  EXPECT_EQ(robot.variable<Locate>("thing").value.position_m, Vec2(0, 0));
  EXPECT_THAT(kept_variables(*before, *robot.executive->description(2)), ElementsAre("count"));
}

TEST(Swap, WhatFadesFasterInTheNewProgramFadesFromTheSameCertainty) {
  const std::string sees = "write_all: name: \"see\" locate_variable: \"trash\" end\n";
  TestRobot robot;
  ASSERT_TRUE(robot.load(Sketch{.variables = "locate: name: \"trash\" memory: 60\n",
                                .perceptual_schemas = sees,
                                .listed = "\"see\""}
                             .text()));
  robot.tick();
  ASSERT_TRUE(robot.load(
      Sketch{.variables = "locate: name: \"trash\" memory: 60\n", .perceptual_schemas = sees}
          .text()));
  robot.tick(20 * 30);
  EXPECT_NEAR(robot.variable<Locate>("trash").certainty_at(robot.now()), 0.5, 1e-9);
  ASSERT_TRUE(robot.load(
      Sketch{.variables = "locate: name: \"trash\" memory: 10\n", .perceptual_schemas = sees}
          .text()));
  robot.tick();
  EXPECT_NEAR(robot.variable<Locate>("trash").certainty_at(robot.now()), 0.5 - 0.05 / 60, 1e-9);
  robot.tick(20);
  EXPECT_NEAR(robot.variable<Locate>("trash").certainty_at(robot.now()), 0.4 - 0.05 / 60, 1e-9);
}

TEST(Swap, OnlyOneProgramWaitsAtATime) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(Sketch{}.text()));
  const auto second = robot.load(Sketch{}.text());
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, testing::HasSubstr("waits"));
  robot.tick();
  EXPECT_TRUE(robot.load(Sketch{}.text()));
}

TEST(Swap, NoTickRunsHalfOfEachProgram) {
  const auto noting = [](const std::string& word) {
    return Sketch{.perceptual_schemas = "note: name: \"n1\" word: \"" + word +
                                        "\" end\nnote: name: \"n2\" word: \"" + word + "\" end\n",
                  .listed = "\"n1\" \"n2\""}
        .text();
  };
  TestRobot robot;
  ASSERT_TRUE(robot.load(noting("old")));
  for (int i = 0; i < 200; ++i) {
    robot.tick();
    ASSERT_TRUE(robot.load(noting(i % 2 ? "old" : "new")));
    journal.clear();
    robot.tick();
    std::erase_if(journal, [](const std::string& word) { return word[0] == '+'; });
    ASSERT_EQ(journal.size(), 2U);
    EXPECT_EQ(journal[0], journal[1]);
    EXPECT_EQ(journal[0], i % 2 ? "old" : "new");
  }
}

}  // namespace
}  // namespace galilean::robot
