// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rehearsal/rehearsal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bhdl/check.h"
#include "robot/executive/executive.h"
#include "robot/rehearsal/given_program.h"
#include "robot/rehearsal/still_devices.h"
#include "robot/rehearsal/timeline.h"

namespace galilean::robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A bumper leads from "wait" to "back_up"; three seconds of contact lead on to "stuck".
constexpr const char* kProgram = R"(
input_devices: comm_port: end end
output_devices: motor_drive: end end
variables:
  shaft: name: "shaft"  status: "valid"
  bits: name: "bumpers"
  bits: name: "stuck"
  bits: name: "seen"
  locate: name: "can"
  locate: name: "goal"  status: "valid"  position: <0, 300>
  bits: name: "home"
  force: name: "ahead"
  force: name: "sum"
end
perceptual_schemas:
  bumper_scanner: name: "scan"  bits_variable: "bumpers"  end
  stuck_detector: name: "detect"  contact_variable: "bumpers"  bits_variable: "stuck"  end
  seen: name: "see"  locate_variable: "can"  bits_variable: "seen"  max_range: 100 cm  end
  arrived: name: "at goal"  shaft_variable: "shaft"  locate_variable: "goal"  bits_variable: "home"  end
end
motor_schemas:
  move_to_goal: name: "go"  shaft_variable: "shaft"  goal_variable: "goal"  result: "ahead"  end
  combine_forces: name: "add"  inputs: "ahead"  result: "sum"  end
  move_robot: name: "move"  input_force: "sum"  shaft_variable: "shaft"  end
end
state:
  name: "wait"
  perceptual_schemas: "scan" "see" end
  condition: bits_variable: "bumpers"  bit_index: 2  new_state: "back_up"  end
  condition: bits_variable: "seen"  new_state: "fetch"  end
end
state:
  name: "go home"
  perceptual_schemas: "at goal" end
  motor_schemas: "go" "add" "move" end
  condition: bits_variable: "home"  new_state: "stuck"  end
end
state:
  name: "back_up"
  perceptual_schemas: "scan" "detect" end
  condition: bits_variable: "stuck"  new_state: "stuck"  end
end
state: name: "fetch" perceptual_schemas: "scan" end end
state: name: "stuck" end
)";

bhdl::Program program_with(const std::string& expectations) {
  auto checked =
      bhdl::check({{"p.bhdl", kProgram + expectations}}, rehearsal_components().catalog());
  for (const auto& each : checked.diagnostics)
    if (each.severity == bhdl::Severity::kError) ADD_FAILURE() << format(each);
  return checked.program.value_or(bhdl::Program());
}

std::vector<ExpectationOutcome> verdicts_of(const std::string& expectations) {
  const auto program = program_with(expectations);
  std::vector<ExpectationOutcome> verdicts;
  for (const auto& each : program.expectations) verdicts.push_back(rehearse(program, each));
  return verdicts;
}

std::string words_of(const std::string& steps) {
  std::string words;
  for (const auto& each : verdicts_of("expect: name: \"it works\" " + steps + " end"))
    words += in_words(each);
  return words;
}

constexpr const char* kPushed = "given: bits_variable: \"bumpers\" bit_index: 2 from: 1 s end ";

TEST(Rehearsal, WhatComesTruePasses) {
  EXPECT_THAT(words_of(std::string(kPushed) + "stays: state: \"wait\" from: 0 until: 0.9 end "
                                              "reaches: state: \"back_up\" by: 1 s end "
                                              "never: state: \"fetch\" end"),
              HasSubstr("passed: it works"));
}

// The scanner finds no bumper pressed and writes so, before and in every tick.
TEST(Rehearsal, WhatIsGivenIsSeenBySchemasWhateverOthersWrite) {
  EXPECT_THAT(words_of(std::string(kPushed) + "stays: state: \"back_up\" from: 1 until: 3.9 end "
                                              "reaches: state: \"stuck\" by: 4.2 s end"),
              HasSubstr("passed: it works"));
}

TEST(Rehearsal, WhatIsGivenEnds) {
  EXPECT_THAT(words_of("given: bits_variable: \"bumpers\" bit_index: 2 from: 1 s until: 2 s end "
                       "stays: state: \"back_up\" from: 1.5 until: 6 end"),
              HasSubstr("passed: it works"));
}

TEST(Rehearsal, APlaceIsGivenInTheRobotsFrame) {
  EXPECT_THAT(words_of("given: locate_variable: \"can\" position: <0, 90> from: 2 end "
                       "reaches: state: \"fetch\" from: 2 by: 2.1 end"),
              HasSubstr("passed: it works"));
  EXPECT_THAT(words_of("given: locate_variable: \"can\" position: <0, 110> end "
                       "never: state: \"fetch\" until: 3 end lasts: 3"),
              HasSubstr("passed: it works"));
}

TEST(Rehearsal, WhereTheRobotIsIsGiven) {
  EXPECT_THAT(words_of("from_state: \"go home\" "
                       "given: shaft_variable: \"shaft\" position: <0, 3 m> from: 2 end "
                       "stays: state: \"go home\" from: 0 until: 1.9 end "
                       "reaches: state: \"stuck\" from: 2 by: 2.1 end"),
              HasSubstr("passed: it works"));
}

/// The force that a robot drives by.
class SumOfForces final : public TickObserver {
 public:
  void on_event(const Event&) noexcept override {}
  void on_tick(const TickView& view) noexcept override {
    for (const auto& each : view.program->variables.all<Force>())
      if (each.name == "sum") force = each.value.value;
  }
  Vec2 force = Vec2::Zero();
};

Vec2 force_after_a_second(const bhdl::Program& program) {
  StillPort port;
  StillDrive drive;
  StillCamera camera;
  SteppedClock clock;
  SumOfForces sum;
  Executive executive({.components = rehearsal_components(),
                       .devices = {port, drive, camera},
                       .clock = clock,
                       .stopwatch = clock,
                       .observers = {&sum}});
  EXPECT_TRUE(executive.load(
      with_givens(program, program.expectations.front(), rehearsal_components().catalog())));
  for (int i = 0; i < 20; ++i, clock.advance(std::chrono::milliseconds(50))) executive.tick();
  return sum.force;
}

TEST(Rehearsal, AForceIsGivenWhateverMotorSchemasWrite) {
  const std::string expectation =
      "expect: name: \"f\" from_state: \"go home\" "
      "stays: state: \"go home\" from: 0 until: 1 end ";
  const auto alone = program_with(expectation + "end");
  const auto given =
      program_with(expectation + "given: force_variable: \"ahead\" value: <-0.5, 0> end end");
  EXPECT_GT(force_after_a_second(alone).y(), 0);
  EXPECT_EQ(force_after_a_second(given), Vec2(-0.5, 0));
}

TEST(Rehearsal, BeginsInTheStateThatItNames) {
  EXPECT_THAT(words_of("from_state: \"fetch\" stays: state: \"fetch\" from: 0 until: 1 end"),
              HasSubstr("passed: it works"));
}

TEST(Rehearsal, AFailureSaysWhereWhatAndWhy) {
  const std::string words = words_of(std::string(kPushed) +
                                     "\nreaches: state: \"fetch\" by: 3 s end\n"
                                     "never: state: \"back_up\" from: 2 until: 3 end");
  EXPECT_THAT(words, HasSubstr("p.bhdl:46:1: failed: it works: the state 'fetch' is not reached by "
                               "3 s; at 3 s it is 'back_up', since 1 s\n"));
  EXPECT_THAT(words, HasSubstr("p.bhdl:47:1: failed: it works: the state 'back_up' is current at "
                               "2 s\n"));
  EXPECT_THAT(words, HasSubstr("  0 s: starts in wait\n"
                               "  1 s: wait → back_up, since bumpers[2] is 1\n"));
}

TEST(Rehearsal, ASchemaThatThrowsIsNamed) {
  const auto program = program_with("");
  const auto failure_of_schema = [&program](std::uint32_t schema) {
    Timeline timeline(program);
    Event event{.kind = Event::Kind::kSchemaFailed};
    event.time = Time{std::chrono::milliseconds(1500)};
    event.schema = schema;
    event.text = ShortText("no room");
    timeline.on_event(event);
    return timeline.failure();
  };
  EXPECT_EQ(failure_of_schema(1), "schema 'detect' threw at 1.5 s: no room");
  EXPECT_EQ(failure_of_schema(5), "schema 'add' threw at 1.5 s: no room");
}

TEST(Rehearsal, AStateThatIsLeftTooEarlyIsAFailure) {
  EXPECT_THAT(
      words_of(std::string(kPushed) + "stays: state: \"wait\" from: 0 until: 2 end"),
      HasSubstr("the state is not 'wait' from 0 s to 2 s; at 1 s it is 'back_up', since 1 s"));
}

TEST(Rehearsal, IsTheSameEveryTimeAndGoesIntoJson) {
  const std::string expectation =
      "expect: name: \"e\" " + std::string(kPushed) + "reaches: state: \"fetch\" by: 2 end end";
  const auto once = nlohmann::json(verdicts_of(expectation));
  EXPECT_EQ(once, nlohmann::json(verdicts_of(expectation)));
  ASSERT_EQ(once.size(), 1u);
  EXPECT_EQ(once[0]["passed"], false);
  EXPECT_EQ(once[0]["failures"][0]["line"], 45);
}

}  // namespace
}  // namespace galilean::robot
