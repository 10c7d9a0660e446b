// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/parser.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace galilean::bhdl {
namespace {

struct Parsed {
  SyntaxTree tree;
  std::vector<Diagnostic> diagnostics;
};

// The tree's views point into the literals that the tests pass.
Parsed parse_text(std::string_view text) {
  Diagnostics diagnostics;
  Parsed result{parse("a.bhdl", text, diagnostics), {}};
  result.diagnostics = std::move(diagnostics).take({"a.bhdl"});
  return result;
}

template <class Node>
std::vector<Node> all(const Parsed& parsed) {
  std::vector<Node> nodes;
  for (const auto& node : parsed.tree)
    if (const auto* found = std::get_if<Node>(&node)) nodes.push_back(*found);
  return nodes;
}

std::string codes(const Parsed& parsed) {
  std::string text;
  for (const auto& each : parsed.diagnostics)
    text += std::to_string(each.line) + ' ' + each.code + '\n';
  return text;
}

TEST(Parser, ClosesBlocksInEverySpelling) {
  const auto parsed = parse_text(
      "input_devices: comm_port: end frame_grabber: end: clock: end;\n end\n"
      "motor_schemas: noise: name: \"a\" end; closed\n swirl: name: \"b\" end: end:");
  EXPECT_EQ(codes(parsed), "");
  ASSERT_EQ(all<SectionNode>(parsed).size(), 2u);
  EXPECT_EQ(all<SectionNode>(parsed)[0].components.size(), 3u);
  EXPECT_EQ(all<SectionNode>(parsed)[1].components.size(), 2u);
}

TEST(Parser, ClosesAVariableByTheNextOne) {
  const auto parsed = parse_text(
      "variables:\n force: name: \"a\" value: <0,–1>\n image:\n name: \"b\"\n"
      " bits: name: \"c\" end\n shaft: name: \"d\"");
  EXPECT_EQ(codes(parsed), "");
  ASSERT_EQ(all<SectionNode>(parsed).size(), 1u);
  const auto variables = all<SectionNode>(parsed)[0].components;
  ASSERT_EQ(variables.size(), 4u);
  EXPECT_EQ(variables[0].attributes[1].values[0].second, -1);
  EXPECT_EQ(variables[3].type.text, "shaft");
}

TEST(Parser, ClosesASectionByTheNextOneAndByTheEnd) {
  const auto parsed = parse_text(
      "variables: bits: name: \"b\"\n percp_schemas: look: name: \"l\" end\n"
      "motor_schemas: noise: name: \"n\" end\n state: name: \"s\" end\n states: state: name: \"t\" "
      "end");
  EXPECT_EQ(codes(parsed), "");
  EXPECT_EQ(all<SectionNode>(parsed).size(), 3u);
  EXPECT_EQ(all<StateNode>(parsed).size(), 2u);
}

TEST(Parser, TellsAStatesListFromASection) {
  const auto parsed = parse_text(
      "state: name: \"s\" perceptual_schemas: end motor_schemas: \"a\" \"b\", \"c\" end\n"
      "condition: new_state: \"s\" end end\n motor_schemas: noise: name: \"n\" end end");
  EXPECT_EQ(codes(parsed), "");
  ASSERT_EQ(all<StateNode>(parsed).size(), 1u);
  const auto state = all<StateNode>(parsed)[0];
  ASSERT_EQ(state.attributes.size(), 3u);
  EXPECT_TRUE(state.attributes[1].values.empty());
  EXPECT_EQ(state.attributes[2].values.size(), 3u);
  EXPECT_EQ(state.conditions.size(), 1u);
  EXPECT_EQ(all<SectionNode>(parsed).size(), 1u);
}

TEST(Parser, TakesASectionWordWithAValueForAnAttribute) {
  const auto parsed =
      parse_text("percp_schemas: forget: name: \"f\" variables: \"a\" \"b\" time: 3 end end");
  EXPECT_EQ(codes(parsed), "");
  ASSERT_EQ(all<SectionNode>(parsed).size(), 1u);
  EXPECT_EQ(all<SectionNode>(parsed)[0].components[0].attributes[1].values.size(), 2u);
}

TEST(Parser, ReadsIncludesStartStateAndSwaps) {
  const auto parsed = parse_text(
      "include \"a.bhdl\" include: “b.bhdl” start_state: \"s\"\n"
      "on_swap: \"old\": \"new\", \"older\": \"new\" end");
  EXPECT_EQ(codes(parsed), "");
  EXPECT_EQ(all<IncludeNode>(parsed).size(), 2u);
  EXPECT_EQ(all<StartStateNode>(parsed).size(), 1u);
  ASSERT_EQ(all<SwapNode>(parsed).size(), 2u);
  EXPECT_EQ(all<SwapNode>(parsed)[1].old_state.text, "older");
}

TEST(Parser, GoesOnAfterAForgottenEnd) {
  const auto parsed = parse_text(
      "motor_schemas:\n noise:\n name: \"a\"\n swirl:\n name: \"b\"\n end\nend\n"
      "state: name: \"s\" motor_schemas: \"a\"\n condition: bit_index: 1\n"
      "state: name: \"t\" end");
  EXPECT_EQ(codes(parsed),
            "4 syntax/unclosed\n9 syntax/unclosed\n10 syntax/unclosed\n10 syntax/unclosed\n");
  EXPECT_EQ(all<SectionNode>(parsed)[0].components.size(), 2u);
  EXPECT_EQ(all<StateNode>(parsed).size(), 2u);
}

TEST(Parser, GoesOnAfterAMisspeltSectionOrPart) {
  const auto parsed = parse_text(
      "varaibles: bits: name: \"b\"\nmotor_schema: noise: name: \"n\" end end\n"
      "stat: name: \"s\" motor_schema: \"n\" end\n conditon: new_state: \"s\" end end\n"
      "strat_state: \"s\"");
  EXPECT_EQ(codes(parsed),
            "1 syntax/unknown-word\n2 syntax/unknown-word\n3 syntax/unknown-word\n"
            "3 syntax/unknown-word\n4 syntax/unknown-word\n5 syntax/unknown-word\n");
  EXPECT_EQ(all<SectionNode>(parsed).size(), 2u);
  ASSERT_EQ(all<StateNode>(parsed).size(), 1u);
  EXPECT_EQ(all<StateNode>(parsed)[0].conditions.size(), 1u);
  EXPECT_EQ(all<StartStateNode>(parsed).size(), 1u);
}

TEST(Parser, ReportsAMistakeOnceAndGoesOn) {
  const std::vector<std::pair<std::string_view, std::string_view>> cases{
      {"end", "1 syntax/unexpected-end\n"},
      {"noise: name: \"n\" end", "1 syntax/unexpected-token\n"},
      {"motor_schemas: noise: name: end end", "1 syntax/missing-value\n"},
      {"motor_schemas: noise: steps: ,3 fresh: 1 end end", "1 syntax/missing-value\n"},
      {"motor_schemas: noise: name \"n\" end end", "1 syntax/missing-colon\n"},
      {"motor_schemas: noise: name: \"n\" steps 3 end end", "1 syntax/missing-colon\n"},
      {"motor_schemas: noise: at: <1 2 3> end end", "1 syntax/pair\n"},
      {"motor_schemas: noise: at: <1, 2) x: 1 end end", "1 syntax/pair\n"},
      {"motor_schemas: noise: > name: \"n\" end end", "1 syntax/unexpected-token\n"},
      {"motor_schemas: noise: end steps: 3 end", "1 syntax/unexpected-token\n"},
      {"states: noise: end state: name: \"s\" end end", "1 syntax/unexpected-token\n"},
      {"include 3 state: name: \"s\" end", "1 syntax/unexpected-token\n"},
      {"include end", "1 syntax/unexpected-token\n"},
      {"on_swap: \"a\" \"b\" end", "1 syntax/unexpected-token\n"},
      {"start_state: end", "1 syntax/unexpected-token\n"},
      {"motor_schemas: noise: name: \"n\"", "1 syntax/unclosed\n"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(codes(parse_text(text)), expected) << text;
}

}  // namespace
}  // namespace galilean::bhdl
