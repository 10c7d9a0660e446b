// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>

#include "bhdl/source/text.h"
#include "tests/bhdl/lsp/editor.h"
#include "tests/bhdl/random_program.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl::lsp {
namespace {

const std::string kGo =
    "states: state: name: \"go\" perceptual_schemas: \"scan\" end "
    "motor_schemas: \"wander\" \"drive\" end end end\n";

TEST(LspDiagnostics, AProgramThatIsRightHasNone) {
  Editor editor;
  editor.open("a.bhdl", program_with_states(kGo));
  EXPECT_EQ(editor.problems("a.bhdl"), "");
  EXPECT_EQ(editor.published("a.bhdl")["version"], 1);
}

TEST(LspDiagnostics, CoverTheTokenWithItsQuotesAndVanishWhenItIsCorrected) {
  Editor editor;
  editor.open("a.bhdl", program_with_states("; 🧹\n; 🧹 \nstates: state: name: \"go\"\n"
                                            "motor_schemas: \"wandr\" \"drive\" end end end\n"));
  EXPECT_EQ(editor.problems("a.bhdl"), "13:15-13:22 name/undefined-schema\n");
  editor.change("a.bhdl", {{{"text", program_with_states(kGo)}}});
  EXPECT_EQ(editor.problems("a.bhdl"), "");
}

TEST(LspDiagnostics, CostNothingUntilNoMessageWaits) {
  Editor editor;
  editor.open("a.bhdl", "nonsense");
  EXPECT_TRUE(editor.server().has_work());
  EXPECT_FALSE(editor.server().work().empty());
  EXPECT_FALSE(editor.server().has_work());
}

TEST(LspDiagnostics, OfWhatIsIncludedGoToItsOwnFile) {
  Editor editor(Files{{"/parts.bhdl", "variables: bts: name: \"x\" end"}});
  editor.open("main.bhdl", "include \"parts.bhdl\"\n" + program_with_states(kGo));
  EXPECT_EQ(editor.problems("main.bhdl"), "");
  EXPECT_EQ(editor.problems("parts.bhdl"), "0:11-0:14 name/unknown-component\n");
}

TEST(LspDiagnostics, WhatIsOpenCountsBeforeWhatIsOnDisk) {
  Editor editor(Files{{"/parts.bhdl", "variables: bts: name: \"x\" end"}});
  editor.open("main.bhdl", "include \"parts.bhdl\"\n" + program_with_states(kGo));
  EXPECT_NE(editor.problems("parts.bhdl"), "");
  editor.open("parts.bhdl", "variables: bits: name: \"x\" end");
  EXPECT_EQ(editor.problems("parts.bhdl").find("unknown-component"), std::string::npos);
  editor.close("parts.bhdl");
  EXPECT_NE(editor.problems("parts.bhdl"), "");
}

TEST(LspDiagnostics, APartIsCheckedInTheProgramsThatIncludeIt) {
  const std::string states =
      "states: state: name: \"go\" motor_schemas: \"wander\" \"drive\" end "
      "perceptual_schemas: \"scan\" end end end\n";
  Editor editor(Files{{"/main.bhdl", "include \"states.bhdl\"\n" + program_with_states("")}});
  editor.open("states.bhdl", states);
  EXPECT_EQ(editor.problems("states.bhdl"), "");
}

TEST(LspDiagnostics, ThoseOfAClosedFileAreTakenBack) {
  Editor editor;
  editor.open("a.bhdl", "nonsense");
  EXPECT_NE(editor.problems("a.bhdl"), "");
  editor.close("a.bhdl");
  EXPECT_EQ(editor.problems("a.bhdl"), "");
}

TEST(LspDiagnostics, NameTheOtherPlaceWhereTheClientShowsIt) {
  Editor editor({}, {{"textDocument", {{"publishDiagnostics", {{"relatedInformation", true}}}}}});
  editor.open("a.bhdl", "variables:\n  bits: name: \"x\"\n  bits: name: \"x\"\nend\n");
  const Json published = editor.published("a.bhdl");
  const Json related = published["diagnostics"].back()["relatedInformation"][0];
  EXPECT_EQ(related["location"]["range"]["start"]["line"], 1);
  EXPECT_EQ(related["message"], "the first");
}

std::string edited_somewhere(const std::string& text, RandomProgram& random) {
  static const std::array<std::string, 8> kPieces{
      "\"", "a", "end", ":", "€", "1.2.3", "include \"parts.bhdl\"\n", "states:\n"};
  const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size() + 1)));
  std::string next = text;
  if (random.chance())
    next.erase(at, static_cast<std::size_t>(random.below(12)));
  else
    next.insert(at, random.one_of(kPieces));
  return find_bad_text(next) ? text : next;
}

Json heard_of(Editor& editor, const std::string& name) {
  const Json published = editor.published(name);
  return published.is_null() ? Json::array() : published["diagnostics"];
}

// Key by key, an editor hears what one hears that opens the text as it is then.
TEST(LspDiagnostics, AfterAnyEditsAreThoseOfTheTextOpenedAnew) {
  const Files parts{{"/parts.bhdl", "variables: bts: name: \"x\" end"}};
  for (unsigned seed = 0; seed < 60; ++seed) {
    RandomProgram random(seed);
    std::string text = random.program();
    Editor typing(parts);
    typing.open("a.bhdl", text);
    for (int edit = 0; edit < 8; ++edit) {
      text = edited_somewhere(text, random);
      typing.change("a.bhdl", {{{"text", text}}});
      Editor anew(parts);
      anew.open("a.bhdl", text);
      for (const char* name : {"a.bhdl", "parts.bhdl"})
        ASSERT_EQ(heard_of(typing, name), heard_of(anew, name)) << "seed " << seed << '\n' << text;
      ASSERT_EQ(typing.ask("textDocument/documentSymbol"), anew.ask("textDocument/documentSymbol"))
          << text;
    }
  }
}

TEST(LspDiagnostics, OfABinaryAndOfAHugeTextAreOne) {
  Editor editor;
  editor.open("a.bhdl", std::string("states:\0\1", 9));
  EXPECT_EQ(editor.problems("a.bhdl"), "0:7-0:7 file/binary\n");
  editor.open("b.bhdl", std::string(600'000, ' '));
  EXPECT_EQ(editor.problems("b.bhdl"), "0:0-0:0 file/too-large\n");
}

TEST(QuickFix, PutsInWhatWasMeant) {
  const std::string text = program_with_states(
      "states: state: name: \"go\" motor_schemas: \"wandr\" \"drive\" end end end\n");
  Editor editor;
  editor.open("a.bhdl", text);
  const Json everywhere{
      {"range",
       {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 99}, {"character", 0}}}}},
      {"context", {{"diagnostics", Json::array()}}}};
  const Json actions = editor.ask("textDocument/codeAction", everywhere);
  ASSERT_EQ(actions.size(), 1u);
  EXPECT_EQ(actions[0]["kind"], "quickfix");
  EXPECT_EQ(actions[0]["title"], "Change to 'wander'");
  const Json edits = actions[0]["edit"]["changes"]["file:///a.bhdl"];
  EXPECT_NE(edited(text, edits).find("motor_schemas: \"wander\" \"drive\""), std::string::npos);
}

TEST(QuickFix, CorrectsLabelsUnitsChoicesAndOldSpellings) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"variables: bist: name: \"x\" end", "bits: name"},
      {"variables: bits: nmae: \"x\" end", "name: \"x\""},
      {"varibles: bits: name: \"x\" end", "variables: bits"},
      {"output_devices: motor_drive: turn_radius: 3 ccm end end", "3 cm end"},
      {"variables: bits: name: \"x\" status: \"vald\" end", "\"valid\""},
      {"output_devices: motor_drive: stright_dead_zones: 1 2 3 4 end end", "straight_dead"}};
  for (const auto& [text, correct] : cases) {
    Editor editor;
    editor.open("a.bhdl", text);
    const Json all{
        {"range",
         {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 9}, {"character", 0}}}}},
        {"context", {{"diagnostics", Json::array()}}}};
    const Json actions = editor.ask("textDocument/codeAction", all);
    ASSERT_FALSE(actions.empty()) << text;
    const Json edits = actions[0]["edit"]["changes"]["file:///a.bhdl"];
    EXPECT_NE(edited(text, edits).find(correct), std::string::npos) << edited(text, edits);
  }
}

TEST(QuickFix, AreNotGivenToWhoAsksForOtherActions) {
  Editor editor;
  editor.open("a.bhdl", "varibles: bits: name: \"x\" end");
  const Json params{
      {"range",
       {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 9}, {"character", 0}}}}},
      {"context", {{"diagnostics", Json::array()}, {"only", {"refactor"}}}}};
  EXPECT_TRUE(editor.ask("textDocument/codeAction", params).empty());
}

}  // namespace
}  // namespace galilean::bhdl::lsp
