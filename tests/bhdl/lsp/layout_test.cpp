// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bhdl/format/formatter.h"
#include "bhdl/lsp/documents/block.h"
#include "core/random.h"
#include "tests/bhdl/lsp/editor.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl::lsp {
namespace {

const std::string kText =
    "; one\n"
    "; two\n"
    "variables:\n"
    "  bits: name: \"x\"\n"
    "  bits: name: \"y\"\n"
    "end\n"
    "define: reach: 3 end\n"
    "states:\n"
    "  state:\n"
    "    name: \"go\"\n"
    "    motor_schemas:\n"
    "      \"a\"\n"
    "    end\n"
    "    condition:\n"
    "      new_state: \"go\"\n"
    "    end\n"
    "  end\n"
    "  state: name: \"open\"\n";

TEST(DocumentSymbols, AreATreeOfWhatIsNamed) {
  Editor editor(
      {}, {{"textDocument", {{"documentSymbol", {{"hierarchicalDocumentSymbolSupport", true}}}}}});
  editor.open("a.bhdl", kText);
  const Json symbols = editor.ask("textDocument/documentSymbol");
  std::string tree;
  for (const auto& section : symbols) {
    tree += section["name"].get<std::string>() + ":";
    for (const auto& child : section.value("children", Json::array()))
      tree += " " + child["name"].get<std::string>();
    tree += "\n";
  }
  EXPECT_EQ(tree, "variables: x y\ndefine: reach\nstates: go open\n");
  EXPECT_EQ(symbols[0]["children"][0]["detail"], "bits");
  EXPECT_EQ(symbols[0]["range"]["end"], (Json{{"line", 5}, {"character", 3}}));
  EXPECT_EQ(symbols[0]["children"][0]["selectionRange"]["start"],
            (Json{{"line", 3}, {"character", 15}}));
}

TEST(DocumentSymbols, AreAListForAClientWithoutTrees) {
  Editor editor;
  editor.open("a.bhdl", kText);
  const Json symbols = editor.ask("textDocument/documentSymbol");
  EXPECT_EQ(symbols.size(), 8u);
  EXPECT_EQ(symbols[1]["containerName"], "variables");
}

TEST(Folding, IsOfBlocksAndComments) {
  Editor editor;
  editor.open("a.bhdl", kText);
  std::string folds;
  for (const auto& each : editor.ask("textDocument/foldingRange"))
    folds += each["startLine"].dump() + "-" + each["endLine"].dump() + " ";
  EXPECT_EQ(folds, "2-5 7-17 8-16 10-12 13-15 0-1 ");
}

TEST(LspFormatting, MakesTheOneLayoutAndTouchesOnlyWhatChanges) {
  const std::string text =
      "variables:\n  bits: name: \"x\"\nend\nstates: state: name:   \"go\" "
      "end end\n; the end\n";
  Editor editor;
  editor.open("a.bhdl", text);
  const Json edits = editor.ask("textDocument/formatting", {{"options", {{"tabSize", 8}}}});
  ASSERT_EQ(edits.size(), 1u);
  EXPECT_EQ(edited(text, edits), *format_text("a.bhdl", text).text);
  EXPECT_GE(edits[0]["range"]["start"]["line"].get<int>(), 3);
}

TEST(LspFormatting, OfWhatIsLaidOutIsNothingAndOfBrokenTextIsRefused) {
  Editor editor;
  editor.open("a.bhdl", *format_text("a.bhdl", kText + "end end").text);
  EXPECT_TRUE(editor.ask("textDocument/formatting").empty());
  editor.open("a.bhdl", "states: state: name: end");
  EXPECT_THAT(editor.refusal("textDocument/formatting"), testing::HasSubstr("correct this first"));
}

TEST(BadText, EveryBeginningOfAProgramGetsAnAnswerToEveryQuestion) {
  const std::string whole = program_with_states(kText + "end on_swap: \"x\": \"go\" end");
  Editor editor;
  for (std::size_t size = 0; size < whole.size(); size += 3) {
    editor.open("a.bhdl", whole.substr(0, size) + "|");
    for (const auto* method :
         {"completion", "hover", "definition", "documentSymbol", "foldingRange", "prepareRename"})
      (void)editor.ask(std::string("textDocument/") + method);
    (void)editor.published("a.bhdl");
  }
}

TEST(BadText, NoiseIsAnswered) {
  Random random(7);
  const std::string alphabet =
      "a:\"“;<>(),.0 \n\r\t\xE2\x80\xF0"
      "end state: variables: define:";
  Editor editor;
  for (int round = 0; round < 300; ++round) {
    std::string text;
    for (std::uint32_t i = random.below(60); i > 0; --i)
      text += alphabet[random.below(static_cast<std::uint32_t>(alphabet.size()))];
    const auto answers = editor.server().receive(dumped(
        {{"jsonrpc", "2.0"},
         {"method", "textDocument/didOpen"},
         {"params",
          {{"textDocument", {{"uri", "file:///n.bhdl"}, {"version", 1}, {"text", text}}}}}}));
    EXPECT_TRUE(answers.empty());
    editor.open("m.bhdl", "include \"n.bhdl\" |");
    (void)editor.ask("textDocument/completion");
    (void)editor.published("n.bhdl");
  }
}

}  // namespace
}  // namespace galilean::bhdl::lsp
