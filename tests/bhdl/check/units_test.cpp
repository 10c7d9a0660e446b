// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

using testing::HasSubstr;

// A whole program with these attributes in a motor schema and a variable.
CheckResult check_with(const std::string& schema, const std::string& variable = {}) {
  return check_text("variables: force: name: \"f\" locate: name: \"can\" " + variable +
                    "\nend motor_schemas:\n noise: name: \"n\" result: \"f\" end\n"
                    " move_robot: name: \"m\" input_force: \"f\" " +
                    schema + "\n end end state: name: \"s\" motor_schemas: \"n\" \"m\" end end");
}

double distance_m(const std::string& written) {
  const auto result = check_with("max_distance_magnitude: " + written);
  EXPECT_TRUE(result.program) << written << '\n' << printed(result);
  if (!result.program) return 0;
  return result.program->motor_schemas.back().attributes.get<double>("max_distance_magnitude");
}

TEST(Units, OfEachKindAreConvertedToSi) {
  for (const auto* half : {"50", "50 cm", "50cm", "0.5 m", ".5m", "500 mm", "500\n mm", "5e-1 m"})
    EXPECT_DOUBLE_EQ(distance_m(half), 0.5) << half;
  EXPECT_DOUBLE_EQ(distance_m("10 in"), 0.254);
  EXPECT_DOUBLE_EQ(distance_m("2 ft"), 0.6096);
}

TEST(Units, PutNothingOutOfRangeByRounding) {
  EXPECT_DOUBLE_EQ(distance_m("1 m"), 1);
  EXPECT_DOUBLE_EQ(distance_m("1000 mm"), 1);
  EXPECT_EQ(summary(check_with("max_distance_magnitude: 1.01 m")),
            "4:65 error value/out-of-range\n");
}

TEST(Units, StandInPairsAndOneDoesForBoth) {
  for (const auto* pair : {"<-10, 22>", "<-10 cm, 22 cm>", "<-0.1 m, 22 cm>", "<-10, 22 cm>",
                           "(-0.1 m 0.22 m)", "<-0.1, 0.22 m>"}) {
    const auto result = check_with("", std::string("position: ") + pair);
    ASSERT_TRUE(result.program) << pair << printed(result);
    const auto position = result.program->variables.back().attributes.get<Vec2>("position");
    EXPECT_NEAR(position.x(), -0.1, 1e-12) << pair;
    EXPECT_NEAR(position.y(), 0.22, 1e-12) << pair;
  }
}

TEST(Units, AreNoWordOfTheNextAttribute) {
  const auto result = check_with("max_distance_magnitude: 50 safety_range: 0.5 rad");
  ASSERT_TRUE(result.program) << printed(result);
  EXPECT_DOUBLE_EQ(result.program->motor_schemas.back().attributes.get<double>("safety_range"),
                   0.5);
}

TEST(Units, ThatDoNotFitSayWhichWould) {
  const auto wrong = check_with("safety_range: 30 cm");
  ASSERT_EQ(wrong.diagnostics.size(), 1u) << printed(wrong);
  EXPECT_EQ(wrong.diagnostics[0].code, "type/wrong-unit");
  EXPECT_EQ(wrong.diagnostics[0].hint, "write it in deg, rad");
  const auto unknown = check_with("safety_range: 30 degs");
  ASSERT_EQ(unknown.diagnostics.size(), 1u) << printed(unknown);
  EXPECT_EQ(unknown.diagnostics[0].code, "syntax/unknown-unit");
  EXPECT_EQ(unknown.diagnostics[0].hint, "did you mean 'deg'?");
}

TEST(Constants, WorkAcrossIncludes) {
  const std::string shared = "define: reach: 0.3 m  far: reach  drive: \"n\" \"m\" end";
  const std::string text =
      "include \"shared.bhdl\" variables: force: name: \"f\"\n"
      "motor_schemas: noise: name: \"n\" result: \"f\" end\n"
      "move_robot: name: \"m\" input_force: \"f\" max_distance_magnitude: far end end\n"
      "state: name: \"s\" motor_schemas: drive end end";
  const auto result = check({{"program.bhdl", text}, {"shared.bhdl", shared}}, small_catalog());
  ASSERT_TRUE(result.program) << printed(result);
  EXPECT_DOUBLE_EQ(
      result.program->motor_schemas[1].attributes.get<double>("max_distance_magnitude"), 0.3);
  EXPECT_EQ(result.program->states[0].motor_schemas, (std::vector<std::string>{"n", "m"}));
}

TEST(Constants, AreBlamedWhereTheyAreUsedWithTheirDefinition) {
  const auto result = check_text(
      program_with_states("define: reach: 2 m end\n"
                          "motor_schemas: move_robot: name: \"m\" input_force: \"ahead\"\n"
                          " max_distance_magnitude: reach end end state: name: \"s\" end"));
  EXPECT_THAT(printed(result), HasSubstr("program.bhdl:13:26: error: 'max_distance_magnitude' of "
                                         "move_robot 'm' is out of range: 200 is not within 0 to "
                                         "100 cm; 'reach' is defined at program.bhdl:11:9"));
}

TEST(Constants, OfConstantsDoNotGrowWithoutEnd) {
  std::string text = "define: a0: 1 1";
  for (int i = 1; i < 60; ++i) {
    const std::string before = "a" + std::to_string(i - 1);
    text += "\na" + std::to_string(i) + ": " + before + ", " + before;
  }
  const auto result = check_text(text + " end state: name: \"s\" end");
  EXPECT_FALSE(result.program);
  EXPECT_THAT(summary(result), HasSubstr("define/too-many"));
}

}  // namespace
}  // namespace galilean::bhdl
