// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bhdl/lsp/editor.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl::lsp {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsSupersetOf;
using testing::Not;

std::vector<std::string> completions_in(const std::string& text) {
  Editor editor;
  editor.open("a.bhdl", text);
  return editor.completions();
}

/// Of the one item with this label, what accepting it makes of the text.
std::string accepted(const std::string& text, const std::string& label, Json capabilities = {}) {
  Editor editor({}, std::move(capabilities));
  editor.open("a.bhdl", text);
  const Json answer = editor.ask("textDocument/completion");
  for (const auto& item : answer["items"])
    if (item["label"] == label) return edited(marked(text).text, Json::array({item["textEdit"]}));
  return "no " + label;
}

const std::string kNames =
    "variables:\n  bits: name: \"bumpers\"\n  bits: name: \"gripper\"\n  force: name: \"ahead\"\n"
    "end\nperceptual_schemas: bumper_scanner: name: \"scan\" bits_variable: \"bumpers\" end end\n"
    "motor_schemas: noise: name: \"wander\" result: \"ahead\" end\n"
    "  move_robot: name: \"drive\" input_force: \"ahead\" end end\n";

TEST(Completion, OutsideEverythingAreSections) {
  const auto labels = completions_in("|");
  EXPECT_THAT(labels, IsSupersetOf({"variables", "motor_schemas", "states", "include", "define",
                                    "start_state", "on_swap", "state"}));
  EXPECT_THAT(labels, Not(Contains("percp_schemas")));
}

TEST(Completion, InASectionAreItsComponents) {
  const auto labels = completions_in("motor_schemas:\n  mo|\nend");
  EXPECT_THAT(labels, IsSupersetOf({"noise", "move_robot", "combine_forces", "end"}));
  EXPECT_THAT(labels, Not(Contains("bits")));
}

TEST(Completion, InAComponentAreTheAttributesThatItHasNot) {
  const auto labels = completions_in(
      "motor_schemas:\n  noise: name: \"n\" |\n    steps: 2\n  end\n  move_robot: end end");
  EXPECT_THAT(labels, IsSupersetOf({"persistence", "fresh", "result", "extends", "end"}));
  EXPECT_THAT(labels, Not(Contains("name")));
  EXPECT_THAT(labels, Not(Contains("steps")));
  EXPECT_THAT(labels, Not(Contains("input_force")));
}

TEST(Completion, InAnExpectationAreItsStepsAndInAStepNamesOfTheRightKind) {
  const auto labels = completions_in("expect:\n  name: \"e\"\n  |\nend");
  EXPECT_THAT(labels, IsSupersetOf({"from_state", "lasts", "given", "reaches", "never", "end"}));
  EXPECT_THAT(labels, Not(Contains("name")));
  EXPECT_THAT(completions_in("expect: name: \"e\"\n given: bits_variable: \"bumpers\" | end end"),
              IsSupersetOf({"bit_index", "from", "until"}));
  const std::string states = "state: name: \"go\" end state: name: \"stop\" end\n";
  for (const auto* step : {"reaches: state: |", "reaches: by: 1 s state: \"|\"", "from_state: |"})
    EXPECT_THAT(completions_in(states + "expect: name: \"e\" " + step + " end end"),
                IsSupersetOf({"go", "stop"}))
        << step;
  EXPECT_THAT(completions_in(kNames + "expect: name: \"e\" given: bits_variable: |"),
              IsSupersetOf({"bumpers", "gripper"}));
}

TEST(Completion, AVariableIsFollowedByAttributesOrTheNext) {
  EXPECT_THAT(completions_in("variables:\n  bits: name: \"x\"\n  |"),
              IsSupersetOf({"value", "status", "locate", "end"}));
}

TEST(Completion, OffersNamesOfTheTypeThatIsRead) {
  const auto labels = completions_in(kNames +
                                     "perceptual_schemas:\n  bumper_scanner:\n"
                                     "    name: \"b\" bits_variable: |");
  EXPECT_THAT(labels, ElementsAre("bumpers", "gripper"));
}

TEST(Completion, OffersEveryVariableWhereAnyWillDo) {
  EXPECT_THAT(completions_in(kNames + "perceptual_schemas: forget: name: \"f\" variables: \"|"),
              ElementsAre("bumpers", "gripper", "ahead"));
}

TEST(Completion, InAStatesListAreTheSchemasThatAreNotListed) {
  const auto labels =
      completions_in(kNames + "states: state: name: \"s\" motor_schemas: \"wander\" | end end end");
  EXPECT_THAT(labels, ElementsAre("drive", "end"));
}

TEST(Completion, OffersStatesToGoTo) {
  const std::string states = "states:\n  state: name: \"go\" end\n  state: name: \"stop\"\n";
  EXPECT_THAT(completions_in(states + "condition: bits_variable: \"b\" new_state: \"|\" end end"),
              ElementsAre("go", "stop"));
  EXPECT_THAT(completions_in(states + "end end\nstart_state: \"|\""), ElementsAre("go", "stop"));
  EXPECT_THAT(completions_in(states + "end end\non_swap: \"old\": \"|\" end"),
              ElementsAre("go", "stop"));
  EXPECT_THAT(completions_in(states + "end\n  state: name: \"next\" extends: \"|\" end"),
              ElementsAre("go", "stop"));
}

TEST(Completion, OffersChoicesFlagsUnitsAndConstants) {
  EXPECT_THAT(completions_in("variables: bits: status: |"), ElementsAre("valid", "invalid"));
  EXPECT_THAT(completions_in("motor_schemas: noise: fresh: |"), ElementsAre("yes", "no"));
  EXPECT_THAT(completions_in("motor_schemas: noise: persistence: 3 |"),
              IsSupersetOf({"s", "ms", "min", "steps"}));
  EXPECT_THAT(completions_in("motor_schemas: noise: persistence: 3m|"),
              IsSupersetOf({"s", "ms", "min"}));
  EXPECT_THAT(completions_in("define: calm: 3 s end\nmotor_schemas: noise: persistence: |"),
              ElementsAre("calm"));
}

TEST(Completion, KnowsTheNamesOfWhatIsIncludedAndOfWhatIncludes) {
  Editor editor(
      {{"/parts.bhdl", kNames}, {"/main.bhdl", "include \"states.bhdl\" include \"parts.bhdl\""}});
  editor.open("states.bhdl", "states: state: motor_schemas: |");
  EXPECT_THAT(editor.completions(), IsSupersetOf({"wander", "drive"}));
}

TEST(Completion, OffersFilesToInclude) {
  Editor editor(Files{{"/parts.bhdl", ""}, {"/main.bhdl", ""}});
  editor.open("main.bhdl", "include: \"|\"");
  EXPECT_THAT(editor.completions(), ElementsAre("parts.bhdl"));
}

TEST(Completion, IsSilentInCommentsAndOnNewNames) {
  EXPECT_TRUE(completions_in("variables: ; bits: |").empty());
  EXPECT_TRUE(completions_in("variables: bits: name: \"|\"").empty());
}

TEST(Completion, WorksWhereTheTextDoesNotParse) {
  EXPECT_THAT(completions_in(")) \"open\nmotor_schemas: noise: name \"x\" 3 : :\n  |"),
              Contains("persistence"));
  EXPECT_THAT(completions_in("motor_schemas: noise: name: \"n\" pers | : 3 end"),
              Contains("persistence"));
  EXPECT_THAT(completions_in(kNames + "motor_schemas: noise: result: \"|\nstates: state: name:"),
              ElementsAre("ahead"));
}

TEST(Completion, OfAHalfTypedAttributeLeavesOutWhatStandsBehindIt) {
  for (const auto* text :
       {"motor_schemas:\n  noise: name: \"n\"\n    per|\n    steps: 2\n  end\nend",
        "motor_schemas:\n  noise: name: \"n\"\n    per|:\n    steps: 2\n  end\nend",
        "motor_schemas:\n  noise: name: \"n\"\n    per|\n    steps: 2\nstates: state:"}) {
    const auto labels = completions_in(text);
    EXPECT_THAT(labels, IsSupersetOf({"persistence", "result"})) << text;
    EXPECT_THAT(labels, Not(Contains("name"))) << text;
    EXPECT_THAT(labels, Not(Contains("steps"))) << text;
  }
}

TEST(Completion, OfAHalfTypedAttributeOfAConditionLeavesOutTheConditionsOwn) {
  const auto labels = completions_in(
      "states:\n  state: name: \"s\"\n    condition: bits_variable: \"b\" bit_|\n"
      "      new_state: \"s\" end\n    condition: bit_index: 2 end\n  end\nend");
  EXPECT_THAT(labels, IsSupersetOf({"bit_index", "bit_value", "reset_variables"}));
  EXPECT_THAT(labels, Not(Contains("new_state")));
  EXPECT_THAT(labels, Not(Contains("bits_variable")));
}

TEST(Completion, OfAHalfTypedBlockAreTheBlocksThatMayStandThere) {
  EXPECT_THAT(completions_in("states:\n  state: name: \"s\"\n    cond|\n  end\nend"),
              Contains("condition"));
  EXPECT_THAT(completions_in("states:\n  state: name: \"s\" end\n  sta|\n  state: name: \"t\" end"),
              Contains("state"));
  EXPECT_THAT(completions_in("motor_schemas:\n  noise: name: \"n\" end\n  mov|\n"
                             "  noise: name: \"m\" end\nend"),
              Contains("move_robot"));
  EXPECT_THAT(completions_in("variables:\n  bits: name: \"b\"\nend\nmoto|\nstates:\n"),
              Contains("motor_schemas"));
}

TEST(Completion, OfAMissingValueAreTheValuesThoughAnAttributeFollows) {
  const auto labels = completions_in(
      kNames +
      "motor_schemas:\n  noise: name: \"m\"\n    result: |\n    persistence: 3\n  end\nend");
  EXPECT_THAT(labels, ElementsAre("ahead"));
}

TEST(Completion, PutsQuotesWhereTheyAreMissing) {
  const std::string reads = kNames + "motor_schemas: move_robot: input_force: ";
  EXPECT_EQ(accepted(reads + "|", "ahead"), reads + "\"ahead\"");
  EXPECT_EQ(accepted(reads + "\"a|\" end", "ahead"), reads + "\"ahead\" end");
  EXPECT_EQ(accepted(reads + "\"a|\nend", "ahead"), reads + "\"ahead\"\nend");
  EXPECT_EQ(accepted(reads + "ah|", "ahead"), reads + "\"ahead\"");
}

TEST(Completion, GivesAComponentWithWhatItNeeds) {
  const Json snippets{
      {"textDocument", {{"completion", {{"completionItem", {{"snippetSupport", true}}}}}}}};
  EXPECT_EQ(accepted("motor_schemas:\nmove|", "move_robot", snippets),
            "motor_schemas:\nmove_robot:\n  name: \"$1\"\n  input_force: \"$2\"\nend");
  EXPECT_EQ(accepted("motor_schemas:\nmove|", "move_robot"), "motor_schemas:\nmove_robot:");
  EXPECT_EQ(accepted("variables:\n|", "bits", snippets), "variables:\nbits:  name: \"$1\"");
}

TEST(Completion, KeepsALabelsColon) {
  EXPECT_EQ(accepted("motor_schemas: noise: per|: 3 end", "persistence"),
            "motor_schemas: noise: persistence: 3 end");
}

TEST(Completion, GivesOneRangeForAllWhereTheClientKnowsDefaults) {
  Editor editor({}, {{"textDocument",
                      {{"completion", {{"completionList", {{"itemDefaults", {"editRange"}}}}}}}}});
  editor.open("a.bhdl", "variables: bi|");
  const Json answer = editor.ask("textDocument/completion");
  EXPECT_EQ(answer["itemDefaults"]["editRange"]["start"]["character"], 11);
  EXPECT_FALSE(answer["items"][0].contains("textEdit"));
}

}  // namespace
}  // namespace galilean::bhdl::lsp
