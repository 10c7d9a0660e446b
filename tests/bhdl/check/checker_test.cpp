// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

using testing::HasSubstr;

const std::string kRightState =
    "state: name: \"go\" perceptual_schemas: \"scan\" end motor_schemas: \"wander\" \"drive\" end\n"
    "condition: bits_variable: \"bumpers\" bit_index: 3 bit_value: 0 bit_update: \"toggle\"\n"
    "new_state: \"go\" reset_variables: \"ahead\" \"bumpers\" end end\n";

TEST(Checker, BuildsTheProgram) {
  const auto result = check_text(program_with_states(kRightState));
  ASSERT_TRUE(result.program) << printed(result);
  EXPECT_EQ(printed(result), "");
  const Program& program = *result.program;
  EXPECT_EQ(program.name, "program.bhdl");
  EXPECT_EQ(program.start_state, "go");
  EXPECT_EQ(program.variables.size(), 3u);
  EXPECT_EQ(program.perceptual_schemas.at(0).type, "bumper_scanner");
  EXPECT_EQ(program.motor_schemas.at(1).name, "drive");
  EXPECT_EQ(program.motor_schemas.at(1).location.line, 9);
  const State& state = *program.find_state("go");
  EXPECT_EQ(state.motor_schemas, (std::vector<std::string>{"wander", "drive"}));
  const Condition& condition = state.conditions.at(0);
  EXPECT_EQ(condition.bit_index, 3u);
  EXPECT_FALSE(condition.bit_value);
  EXPECT_EQ(condition.bit_update, BitUpdate::kToggle);
  EXPECT_EQ(condition.reset_variables.size(), 2u);
  EXPECT_EQ(condition.location.line, 12);
  EXPECT_EQ(program.find_state("gone"), nullptr);
}

TEST(Checker, ConvertsValuesAndDefaultsToSi) {
  const auto result = check_text(program_with_states(
      kRightState +
      "variables: locate: name: \"can\" position: (25, -50)\n"
      "output_devices: motor_drive: turn_radius: 20 stright_dead_zones: 1 2 –3 −4 end end\n"
      "input_devices: frame_grabber: view_angle: 90 end end"));
  ASSERT_TRUE(result.program) << printed(result);
  const Program& program = *result.program;
  const auto& drive = program.motor_schemas.at(1).attributes;
  EXPECT_DOUBLE_EQ(drive.get<double>("max_distance_magnitude"), 0.15);
  EXPECT_DOUBLE_EQ(drive.get<double>("safety_range"), std::numbers::pi / 6);
  EXPECT_EQ(program.variables.back().attributes.get<Vec2>("position"), Vec2(0.25, -0.5));
  const auto& motors = program.devices.at(0).attributes;
  EXPECT_DOUBLE_EQ(motors.get<double>("turn_radius"), 0.2);
  EXPECT_EQ(motors.get<std::vector<double>>("straight_dead_zones"),
            (std::vector<double>{1, 2, -3, -4}));
  EXPECT_EQ(program.devices.at(0).name, "motor_drive");
  EXPECT_DOUBLE_EQ(program.devices.at(1).attributes.get<double>("view_angle"),
                   std::numbers::pi / 2);
}

TEST(Checker, LoadsTheMisspeltAttributeWithAHint) {
  const auto result = check_text(program_with_states(
      kRightState + "output_devices: motor_drive: stright_dead_zones: 1 2 3 4 end end"));
  EXPECT_TRUE(result.program);
  ASSERT_EQ(summary(result), "14:30 warning name/misspelt-attribute\n");
  EXPECT_THAT(result.diagnostics[0].hint, HasSubstr("straight_dead_zones"));
}

TEST(Checker, ReadsFlagsAndChoicesWithAndWithoutQuotes) {
  for (const auto* no : {"no", "\"no\"", "0", "false", "off"}) {
    const auto result = check_text(program_with_states(
        kRightState + "motor_schemas: noise: name: \"m\" result: \"ahead\" fresh: " + no +
        " end end variables: bits: name: \"b\" status: valid"));
    ASSERT_TRUE(result.program) << no << printed(result);
    EXPECT_FALSE(result.program->motor_schemas.back().attributes.get<bool>("fresh")) << no;
    EXPECT_EQ(result.program->variables.back().attributes.get<std::string>("status"), "valid");
  }
}

TEST(Checker, LetsAnOptionalNameBeLeftOutButLooksForAPresetOne) {
  const std::string without_shaft =
      "variables: bits: name: \"b\" locate: name: \"can\"\n"
      "perceptual_schemas: forget: name: \"f\" variables: \"b\" end\n"
      "obstacle_detector: name: \"o\" bits_variable: \"b\" obstacle_variable: \"can\" end end\n"
      "state: name: \"s\" end";
  const auto result = check_text(without_shaft);
  EXPECT_EQ(summary(result), "3:1 error name/undefined-variable\n") << printed(result);
}

TEST(Checker, WantsOneGainForEachForce) {
  const auto with_gains = [](const std::string& gains) {
    return check_text(program_with_states(
        kRightState +
        "variables: force: name: \"back\"\n"
        "motor_schemas: combine_forces: name: \"c\" forces: \"ahead\" \"back\" " +
        gains + " result: \"ahead\" end end"));
  };
  EXPECT_TRUE(with_gains("").program);
  EXPECT_TRUE(with_gains("gains: 1, 0.5").program);
  EXPECT_EQ(summary(with_gains("gains: 1 2 3")), "15:16 error value/count\n");
}

TEST(Checker, NamesBothEndsAndBothTypes) {
  const auto result = check_text(program_with_states(
      kRightState + "motor_schemas: move_robot: name: \"m\" input_force: \"bumpers\" end end"));
  EXPECT_THAT(printed(result),
              HasSubstr("program.bhdl:14:51: error: 'input_force' of move_robot 'm' takes a force "
                        "variable, but 'bumpers' is a bits variable: see program.bhdl:3:15"));
}

TEST(Checker, DoesNotCareForTheOrderOfTheText) {
  const auto result = check_text(
      "states: state: name: \"s\" motor_schemas: \"n\" end end end\n"
      "motor_schemas: noise: name: \"n\" result: \"f\" end end\n"
      "variables: force: name: \"f\"");
  EXPECT_TRUE(result.program) << printed(result);
}

TEST(Checker, LetsASchemaAndItsVariableShareAName) {
  const auto result = check_text(
      "variables: force: name: \"aso0\"\n"
      "motor_schemas: noise: name: \"aso0\" result: \"aso0\" end end\n"
      "state: name: \"aso0\" motor_schemas: \"aso0\" end end");
  EXPECT_TRUE(result.program) << printed(result);
}

TEST(Checker, HintsAtTheOtherListOfSchemas) {
  const auto result =
      check_text(program_with_states("state: name: \"s\" motor_schemas: \"scan\" end end"));
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_THAT(result.diagnostics[0].hint, HasSubstr("is a perceptual schema"));
}

TEST(Checker, KnowsTheStartStateAndTheSwaps) {
  const auto result =
      check_text(program_with_states("start_state: \"b\"\non_swap: \"old\": \"c\" end\n"
                                     "states: state: name: \"a\" perceptual_schemas: \"scan\" end\n"
                                     "motor_schemas: \"wander\" \"drive\" end end\n"
                                     "state: name: \"b\" end state: name: \"c\" end end"));
  ASSERT_TRUE(result.program) << printed(result);
  EXPECT_EQ(result.program->start_state, "b");
  EXPECT_EQ(result.program->on_swap.at("old"), "c");
  EXPECT_EQ(summary(result), "13:9 warning state/unreachable\n") << "of a";
}

TEST(Checker, GivesAValuelessVariableAttributeItsName) {
  const auto result = check_text(
      "variables: shaft: name: \"s\" position: heading: 90 status: \"valid\"\n"
      "state: name: \"go\" end");
  EXPECT_EQ(summary(result), "1:29 error syntax/missing-value\n") << printed(result);
}

TEST(Checker, BlamesNothingElseForWhatCouldNotBeRead) {
  const auto result = check_text(program_with_states(
      "motor_schemas: noise name: \"n\" end end\n"
      "state: name: \"s\" motor_schemas: \"n\" end condition: bits_variable: \"bumpers\" end end"));
  EXPECT_EQ(summary(result), "11:16 error syntax/missing-colon\n") << printed(result);
}

TEST(Checker, ReportsManyErrorsInTheOrderOfTheText) {
  const auto result = check_text(program_with_states(
      "state: name: \"s\" motor_schemas: \"wandr\" end\n"
      "condition: bits_variable: \"bumpres\" bit_index: 32 new_state: \"t\" end end\n"
      "motor_schemas: nois: name: \"n\" end noise: name: \"m\" reslt: \"ahead\" steps: 1.5 end "
      "end"));
  EXPECT_EQ(summary(result),
            "11:33 error name/undefined-schema\n"
            "12:27 error name/undefined-variable\n"
            "12:48 error value/out-of-range\n"
            "12:62 error name/undefined-state\n"
            "13:16 error name/unknown-component\n"
            "13:36 error name/missing-attribute\n"
            "13:53 error name/unknown-attribute\n"
            "13:75 error type/wrong-value\n")
      << printed(result);
}

TEST(Checker, StopsAtAHundredAndSaysHowManyMore) {
  std::string text = "motor_schemas:\n";
  for (int i = 0; i < 250; ++i) text += "nonsense: end\n";
  const auto result = check_text(text + "end state: name: \"s\" end");
  ASSERT_EQ(result.diagnostics.size(), 101u);
  EXPECT_EQ(result.diagnostics.back().code, "too-many");
  EXPECT_THAT(result.diagnostics.back().message, HasSubstr("150 more"));
}

TEST(Checker, WantsAState) {
  EXPECT_EQ(summary(check_text("")), "1:1 error state/none\n");
  EXPECT_EQ(summary(check_text("; nothing")), "1:1 error state/none\n");
}

}  // namespace
}  // namespace galilean::bhdl
