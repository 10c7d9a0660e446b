// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/extension.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Extension, TakesWhatItDoesNotGiveItself) {
  const auto result = check_text(program_with_states(
      "motor_schemas:\n"
      "noise: name: \"calm\" extends: \"slow\" steps: 7 end\n"
      "noise: name: \"slow\" extends: \"wander\" persistence: 60 steps: 5 end end\n"
      "state: name: \"s\" motor_schemas: \"calm\" \"drive\" end end"));
  ASSERT_TRUE(result.program) << printed(result);
  const Component& calm = result.program->motor_schemas[2];
  EXPECT_EQ(calm.name, "calm");
  EXPECT_EQ(calm.attributes.get<double>("persistence"), 60);
  EXPECT_EQ(calm.attributes.get<double>("steps"), 7);
  EXPECT_EQ(calm.attributes.get<std::string>("result"), "ahead");
  EXPECT_EQ(calm.location.line, 12);
}

TEST(Extension, OfAVariableWorksToo) {
  const auto result = check_text(
      "variables: locate: name: \"can\" extends: \"thing\" position: (0, 1 m)\n"
      "locate: name: \"thing\" status: \"valid\" position: (1, 1)\n"
      "state: name: \"s\" end");
  ASSERT_TRUE(result.program) << printed(result);
  const auto& can = result.program->variables[0].attributes;
  EXPECT_EQ(can.get<std::string>("status"), "valid");
  EXPECT_EQ(can.get<Vec2>("position"), Vec2(0, 1));
}

TEST(Extension, OfAStateReplacesListsAndPutsConditionsInFront) {
  const std::string base =
      "state: name: \"base\" percp_schemas: \"scan\" end motor_schemas: \"wander\" \"drive\" end\n"
      "condition: bits_variable: \"bumpers\" bit_index: 1 new_state: \"base\" end\n"
      "condition: bits_variable: \"bumpers\" bit_index: 2 new_state: \"base\" end end\n";
  const auto result =
      check_text(program_with_states(
          base + "state: name: \"own\" extends: \"base\" motor_schemas: end\n"
                 "condition: bits_variable: \"bumpers\" bit_index: 3 new_state: \"base\" end\n"
                 "condition: bits_variable: \"bumpers\" bit_index: 1 new_state: \"own\" end end"));
  ASSERT_TRUE(result.program) << printed(result);
  const State& own = result.program->states[1];
  EXPECT_THAT(own.perceptual_schemas, ElementsAre("scan"));
  EXPECT_TRUE(own.motor_schemas.empty());
  ASSERT_EQ(own.conditions.size(), 3u);
  EXPECT_EQ(own.conditions[0].bit_index, 3u);
  EXPECT_EQ(own.conditions[1].new_state, "own") << "in place of the base's";
  EXPECT_EQ(own.conditions[2].bit_index, 2u);
  EXPECT_EQ(own.conditions[2].location.line, 13);
}

TEST(Extension, WorksAcrossIncludes) {
  const auto result = check(
      {{"program.bhdl",
        "include \"base.bhdl\" start_state: \"own\"\n"
        "state: name: \"own\" extends: \"base\" end"},
       {"base.bhdl",
        program_with_states("state: name: \"base\" motor_schemas: \"wander\" \"drive\" end end")}},
      small_catalog());
  ASSERT_TRUE(result.program) << printed(result);
  EXPECT_EQ(printed(result), "");
  EXPECT_THAT(result.program->states[1].motor_schemas, ElementsAre("wander", "drive"));
}

TEST(Extension, ChainsAsLongAsAProgramAreFollowed) {
  std::string text =
      "state: name: \"s0\" condition: bits_variable: \"bumpers\" new_state: \"s0\" "
      "end end\n";
  for (int i = 1; i < 5000; ++i)
    text += "state: name: \"s" + std::to_string(i) + "\" extends: \"s" + std::to_string(i - 1) +
            "\" end\n";
  const auto chain = check_text(program_with_states(text));
  ASSERT_TRUE(chain.program) << printed(chain);
  EXPECT_EQ(chain.program->states.back().conditions.size(), 1u);
  const auto circle = check_text(program_with_states(
      text + "state: name: \"x\" extends: \"y\" end state: name: \"y\" extends: \"x\" end"));
  EXPECT_THAT(summary(circle), HasSubstr("error extends/cycle"));
}

TEST(Extension, DoesNotGrowWithoutEnd) {
  std::string text = "state: name: \"s\"\n";
  for (int i = 0; i < 2000; ++i)
    text += "condition: bits_variable: \"bumpers\" new_state: \"s\" end\n";
  text += "end\n";
  for (int i = 0; i < 2000; ++i)
    text += "state: name: \"t" + std::to_string(i) + "\" extends: \"s\" end\n";
  const auto result = check_text(program_with_states(text));
  EXPECT_FALSE(result.program);
  EXPECT_THAT(summary(result), HasSubstr("error extends/too-many"));
}

}  // namespace
}  // namespace galilean::bhdl
