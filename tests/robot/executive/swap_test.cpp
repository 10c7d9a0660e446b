#include <gmock/gmock.h>

#include <map>

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

/// Programs drawn at random, of three states and four variables that each may or may not have.
class RandomPrograms {
 public:
  explicit RandomPrograms(std::uint64_t seed) : random_(seed) {}

  std::string draw() {
    Sketch sketch{.states = {}};
    for (const char* state : {"a", "b", "c"})
      if (random_.below(2)) sketch.states.emplace_back(state);
    if (sketch.states.empty()) sketch.states.emplace_back("d");
    for (const char* name : {"v0", "v1", "v2", "v3"}) {
      const bool is_locate = random_.below(2);
      if (random_.below(4) == 0) continue;
      sketch.variables += std::string(is_locate ? "locate" : "force") + ": name: \"" + name +
                          "\" memory: " + std::to_string(10 + random_.below(3) * 25) + "\n";
      const std::string writer = std::string("write_") + name;
      sketch.perceptual_schemas += "write_all: name: \"" + writer + "\" " +
                                   (is_locate ? "locate" : "force") + "_variable: \"" + name +
                                   "\" certainty: 0." + std::to_string(1 + random_.below(9)) +
                                   " end\n";
      if (random_.below(2)) sketch.listed += "\"" + writer + "\" ";
    }
    return sketch.text();
  }
  std::uint32_t below(std::uint32_t count) { return random_.below(count); }

 private:
  Random random_;
};

struct Kept {
  Vec2 value = Vec2::Zero();
  bool valid = false;
  double certainty = 0;
  bool operator==(const Kept&) const = default;
};

/// By name and type, as of `now`.
std::map<std::string, Kept> contents(const RunningProgram& program, Time now) {
  std::map<std::string, Kept> found;
  for (const auto& each : program.variables.all<Locate>())
    found["locate " + each.name] = {each.value.position_m, each.valid_at(now),
                                    each.certainty_at(now)};
  for (const auto& each : program.variables.all<Force>())
    found["force " + each.name] = {each.value.value, each.valid_at(now), each.certainty_at(now)};
  return found;
}

TEST(Swap, AnyPairOfProgramsAtAnyTickKeepsWhatBothKnow) {
  RandomPrograms programs(7);
  for (int round = 0; round < 300; ++round) {
    TestRobot robot;
    ASSERT_TRUE(robot.load(programs.draw()));
    robot.tick(1 + static_cast<int>(programs.below(40)));
    const auto old_contents =
        contents(*robot.executive->program(), robot.now() + std::chrono::milliseconds(50));
    const std::string old_state = robot.state();
    ASSERT_TRUE(robot.load(programs.draw()));
    robot.tick();
    const RunningProgram& running = *robot.executive->program();
    const auto& schemas = running.text().states[running.state].perceptual_schemas;
    for (const auto& [name, now_holds] : contents(running, robot.now())) {
      const bool written = std::ranges::count(schemas, "write_" + name.substr(name.find(' ') + 1));
      const auto held = old_contents.find(name);
      if (written) {
        EXPECT_EQ(now_holds.value.x(), robot.executive->last_tick().number);
      } else if (held != old_contents.end()) {
        EXPECT_EQ(now_holds, held->second) << name << " in round " << round;
      } else {
        EXPECT_EQ(now_holds, Kept{}) << name << " in round " << round;
      }
    }
    const bool had_state = running.text().find_state(old_state) != nullptr;
    EXPECT_EQ(robot.state(), had_state ? old_state : running.text().start_state);
  }
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
