// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bhdl/lsp/editor.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl::lsp {
namespace {

using testing::HasSubstr;

const std::string kProgram =
    "; What the microcontroller says.\n"
    "variables:\n"
    "  bits: name: \"bumpers\"  ; 0: in front\n"
    "  shaft: name: \"shaft\"\n"
    "  force: name: \"ahead\"\n"
    "end\n"
    "perceptual_schemas: bumper_scanner: name: \"scan\" bits_variable: \"bumpers\" end end\n"
    "motor_schemas:\n"
    "  noise: name: \"ahead\" result: \"ahead\" persistence: 3 s end\n"
    "  move_robot: name: \"drive\" input_force: \"ahead\" end\n"
    "end\n"
    "define: all: \"ahead\" \"drive\" end\n"
    "states:\n"
    "  state:\n"
    "    name: \"go\"\n"
    "    perceptual_schemas: \"scan\" end\n"
    "    motor_schemas: all end\n"
    "    condition: bits_variable: \"bumpers\" bit_index: 0 new_state: \"stop\" end\n"
    "  end\n"
    "  state: name: \"stop\" end\n"
    "end\n"
    "start_state: \"go\"\n"
    "on_swap: \"stop\": \"stop\" end\n";

/// The program with the cursor before the first `here` behind `after`.
std::string at(const std::string& after, const std::string& here) {
  std::string text = kProgram;
  return text.insert(text.find(here, text.find(after)), "|");
}

std::string hovered(const std::string& text) {
  Editor editor({}, {{"textDocument", {{"hover", {{"contentFormat", {"markdown"}}}}}}});
  editor.open("a.bhdl", text);
  const Json answer = editor.ask("textDocument/hover");
  return answer.is_null() ? "nothing" : answer["contents"]["value"].get<std::string>();
}

std::vector<std::string> starts(const Json& locations) {
  std::vector<std::string> places;
  for (const auto& each : locations)
    places.push_back(each["range"]["start"]["line"].dump() + ":" +
                     each["range"]["start"]["character"].dump());
  return places;
}

TEST(Hover, OfAComponentIsWhatItDoesAndTakes) {
  EXPECT_THAT(hovered(at("motor_schemas", "noise")),
              testing::AllOf(HasSubstr("**noise**, motor schema"), HasSubstr("A random heading."),
                             HasSubstr("`persistence`: a number in s; default 5 s; 0 to 600 s")));
  EXPECT_THAT(hovered(at("motor_schemas: all", "condition")), HasSubstr("A way out of the state"));
}

TEST(Hover, OfAnAttributeAndItsValueIsItsUnitDefaultAndRange) {
  for (const auto* here : {"persistence", "3 s"})
    EXPECT_THAT(hovered(at("noise", here)), HasSubstr("a number in s; default 5 s; 0 to 600 s"))
        << here;
}

TEST(Hover, OfANameIsItsDeclarationWithItsComment) {
  const auto text = hovered(at("condition", "bumpers"));
  EXPECT_THAT(text, HasSubstr("**bumpers**, variable, bits"));
  EXPECT_THAT(text, HasSubstr("bits: name: \"bumpers\"  ; 0: in front"));
  EXPECT_THAT(text, HasSubstr("a.bhdl:3"));
}

TEST(Hover, OfABitIsWhoWritesIt) {
  const auto text = hovered(at("bit_index: ", "0 new_state"));
  EXPECT_THAT(text, HasSubstr("**bit 0** of 'bumpers'"));
  EXPECT_THAT(text, HasSubstr("written by bumper_scanner 'scan': Reads the bumpers."));
  EXPECT_THAT(text, HasSubstr("; 0: in front"));
}

TEST(Hover, OfNothingIsNothing) {
  EXPECT_EQ(hovered("; |comment\n"), "nothing");
}

TEST(Navigation, FindsTheDeclarationOfItsOwnKind) {
  Editor editor;
  editor.open("a.bhdl", at("input_force: ", "ahead"));
  EXPECT_THAT(starts(editor.ask("textDocument/definition")), testing::ElementsAre("4:16"));
}

TEST(Navigation, FindsWhatAConstantsTextNames) {
  Editor editor;
  editor.open("a.bhdl", at("define: all", "ahead"));
  EXPECT_THAT(starts(editor.ask("textDocument/definition")), testing::ElementsAre("8:16"));
}

TEST(Navigation, OpensWhatIsIncluded) {
  Editor editor(Files{{"/parts.bhdl", ""}});
  editor.open("main.bhdl", "include \"pa|rts.bhdl\"");
  EXPECT_EQ(editor.ask("textDocument/definition")["uri"], "file:///parts.bhdl");
}

TEST(Navigation, ReferencesAreOfOneKindOfName) {
  Editor editor;
  editor.open("a.bhdl", at("input_force: ", "ahead"));
  const Json with{{"context", {{"includeDeclaration", true}}}};
  const Json without{{"context", {{"includeDeclaration", false}}}};
  EXPECT_THAT(starts(editor.ask("textDocument/references", with)),
              testing::ElementsAre("4:16", "8:32", "9:42"));
  EXPECT_THAT(starts(editor.ask("textDocument/references", without)),
              testing::ElementsAre("8:32", "9:42"));
}

TEST(Navigation, TheOldStateOfASwapIsAnotherProgramsState) {
  Editor editor;
  editor.open("a.bhdl", at("on_swap: \"stop\"", "stop\" end"));
  const Json with{{"context", {{"includeDeclaration", true}}}};
  EXPECT_THAT(starts(editor.ask("textDocument/references", with)),
              testing::ElementsAre("17:65", "19:16", "22:18"));
}

std::string renamed(const std::string& text, const std::string& new_name) {
  Editor editor;
  editor.open("a.bhdl", text);
  const Json edit = editor.ask("textDocument/rename", {{"newName", new_name}});
  return edited(marked(text).text, edit["changes"]["file:///a.bhdl"]);
}

TEST(Rename, ChangesEveryPlaceAndNothingElse) {
  const std::string text = renamed(at("noise: name", "ahead"), "dither");
  EXPECT_THAT(text, HasSubstr("noise: name: \"dither\" result: \"ahead\""));
  EXPECT_THAT(text, HasSubstr("define: all: \"dither\" \"drive\""));
  EXPECT_TRUE(check_text(text).program.has_value()) << printed(check_text(text));
}

TEST(Rename, OfAConstantTakesItsUses) {
  EXPECT_THAT(renamed(at("define: ", "all"), "both"), HasSubstr("motor_schemas: both end"));
}

TEST(Rename, RefusesWhatCannotBeANameOrIsTaken) {
  Editor editor;
  editor.open("a.bhdl", at("name: \"go", "go"));
  for (const auto* bad : {"", "a\"b", "a\nb", "a“b"})
    EXPECT_THAT(editor.refusal("textDocument/rename", {{"newName", bad}}),
                HasSubstr("cannot be a name"));
  EXPECT_THAT(editor.refusal("textDocument/rename", {{"newName", "stop"}}),
              HasSubstr("there is a state 'stop' already: it is at /a.bhdl:20:17"));
  editor.open("a.bhdl", at("define: ", "all"));
  EXPECT_THAT(editor.refusal("textDocument/rename", {{"newName", "two words"}}),
              HasSubstr("letters, digits and _"));
  EXPECT_THAT(editor.refusal("textDocument/rename", {{"newName", "end"}}),
              HasSubstr("would be wrong"));
}

TEST(Rename, RefusesWhatADefaultNames) {
  Editor editor;
  const std::string detector =
      "variables: locate: name: \"o\" end\nperceptual_schemas: obstacle_detector: name: \"od\" "
      "bits_variable: \"bumpers\" obstacle_variable: \"o\" end end\n";
  editor.open("a.bhdl", at("shaft: name", "shaft\"") + detector);
  EXPECT_THAT(editor.refusal("textDocument/rename", {{"newName", "wheel"}}),
              HasSubstr("would be wrong with that name"));
}

TEST(Rename, IsPreparedOnlyWhereAProgramDeclaresTheName) {
  Editor editor;
  editor.open("a.bhdl", at("start_state", "go"));
  EXPECT_EQ(editor.ask("textDocument/prepareRename")["placeholder"], "go");
  editor.open("a.bhdl", at("states:", "state:"));
  EXPECT_TRUE(editor.ask("textDocument/prepareRename").is_null());
  EXPECT_THAT(editor.refusal("textDocument/rename", {{"newName", "x"}}),
              HasSubstr("here is no name"));
}

TEST(Rename, ReachesEveryProgramThatSharesTheNamesPart) {
  const std::string shared =
      "states: state: name: \"a\" condition: bits_variable: \"b\" "
      "new_state: \"search\" end end end\n";
  const auto main = [](const std::string& more) {
    return "include \"shared.bhdl\"\nvariables: bits: name: \"b\" end\n"
           "states: state: name: \"search\" end " +
           more + " end\n";
  };
  Editor editor(Files{{"/one.bhdl", main("")},
                      {"/two.bhdl", main("state: name: \"own\" end")},
                      {"/shared.bhdl", shared},
                      {"/other.bhdl", "states: state: name: \"search\" end end"}},
                {{"workspace", {{"workspaceEdit", {{"documentChanges", true}}}}}});
  std::string text = main("");
  editor.open("one.bhdl", text.insert(text.find("search"), "|"));
  const Json edit = editor.ask("textDocument/rename", {{"newName", "roam"}});
  std::vector<std::string> files;
  for (const auto& each : edit["documentChanges"]) files.push_back(each["textDocument"]["uri"]);
  EXPECT_THAT(files,
              testing::ElementsAre("file:///one.bhdl", "file:///shared.bhdl", "file:///two.bhdl"));
  EXPECT_EQ(edit["documentChanges"][0]["textDocument"]["version"], 1);
  EXPECT_TRUE(edit["documentChanges"][1]["textDocument"]["version"].is_null());

  std::string own = main("state: name: \"own\" end");
  editor.open("two.bhdl", own.insert(own.find("own"), "|"));
  EXPECT_EQ(editor.ask("textDocument/rename", {{"newName", "mine"}})["documentChanges"].size(), 1u);
}

}  // namespace
}  // namespace galilean::bhdl::lsp
