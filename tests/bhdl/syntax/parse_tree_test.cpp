// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/parse_tree.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "bhdl/syntax/parser.h"
#include "bhdl/syntax/trivia.h"
#include "tests/bhdl/random_program.h"

// What must hold of the tree whatever the text.

namespace galilean::bhdl {
namespace {

namespace fs = std::filesystem;

/// The parts of what stands between two tokens.
std::string written_again(std::string_view gap) {
  std::string text;
  while (!gap.empty()) {
    const Trivia trivia = first_trivia(gap);
    EXPECT_FALSE(trivia.text.empty());
    text += trivia.text;
    gap.remove_prefix(trivia.text.size());
  }
  return text;
}

/// Every token with what stands before it.
std::string written_again(const ParseTree& tree) {
  std::string text;
  for (std::size_t i = 0; i < tree.tokens.size(); ++i)
    text.append(written_again(tree.gap_before(i))).append(tree.tokens[i].whole());
  return text;
}

/// A node's children stand in it, in order, one behind the other.
void expect_nested(const ParseTree& tree, const NodeRange& nodes, const Node& parent) {
  std::uint32_t token = parent.first_token;
  for (const auto i : nodes) {
    const Node& node = tree.nodes[i];
    ASSERT_GE(node.first_token, token);
    ASSERT_GT(node.end_token, node.first_token);
    ASSERT_LE(node.end_token, parent.end_token);
    ASSERT_LE(node.end_node, parent.end_node);
    token = node.end_token;
    expect_nested(tree, tree.children(i), node);
  }
}

/// Outside the nodes stands nothing but the end of the file.
void expect_all_in_nodes(const ParseTree& tree) {
  std::uint32_t token = 0;
  for (const auto i : tree.roots()) {
    EXPECT_EQ(tree.nodes[i].first_token, token);
    token = tree.nodes[i].end_token;
  }
  EXPECT_EQ(token + 1, tree.tokens.size());
}

void expect_lossless(const std::string& text) {
  Diagnostics diagnostics;
  const ParseTree tree = parse_tree("program.bhdl", text, diagnostics);
  ASSERT_EQ(written_again(tree), text);
  const auto end = static_cast<std::uint32_t>(tree.nodes.size());
  expect_nested(tree, tree.roots(),
                {NodeKind::kError, 0, 0, static_cast<std::uint32_t>(tree.tokens.size()), end});
  expect_all_in_nodes(tree);
}

std::vector<std::string> texts_in(const fs::path& folder) {
  std::vector<std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".bhdl") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    texts.push_back(text.str());
  }
  return texts;
}

std::vector<std::string> texts_of_files() {
  std::vector<std::string> texts;
  for (const auto* folder : {"bhdl/programs", "tests/cases", "tests/fuzz/corpus"})
    for (auto& text : texts_in(fs::path(GALILEAN_SOURCE_DIR) / folder))
      texts.push_back(std::move(text));
  return texts;
}

TEST(ParseTree, LosesNothingOfAFile) {
  const auto texts = texts_of_files();
  EXPECT_GT(texts.size(), 40u);
  for (const auto& text : texts) {
    expect_lossless(text);
    if (testing::Test::HasFailure()) FAIL() << text;
  }
}

// Damage puts in bytes that are no UTF-8 and control characters.
TEST(ParseTree, LosesNothingOfADamagedText) {
  const auto files = texts_of_files();
  for (unsigned seed = 0; seed < 2000; ++seed) {
    RandomProgram random(seed);
    const std::string program = seed % 2 == 0 ? random.program() : random.one_of(files);
    const std::string text = damaged(program, random);
    expect_lossless(text);
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed << '\n' << text;
  }
}

TEST(ParseTree, LosesNothingOfAnyBytes) {
  static const std::string kBytes =
      "\"\xE2\x80\x9C\x9D\x93; \n\r\t:,<>()end=.-5e+3x\xFF\xEF\xBB\xBF\x7F";
  for (unsigned seed = 0; seed < 2000; ++seed) {
    RandomProgram random(seed);
    std::string text(static_cast<std::size_t>(random.below(200)), ' ');
    for (auto& byte : text)
      byte = random.chance() ? random.one_of(kBytes) : static_cast<char>(random.below(256));
    expect_lossless(text);
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed;
  }
}

TEST(Trivia, AreBlanksLineEndsCommentsAndWhatIsNoToken) {
  const std::vector<std::pair<std::string_view, Trivia::Kind>> parts{
      {"\uFEFF \t", Trivia::Kind::kBlank}, {"; a “b” ", Trivia::Kind::kComment},
      {"\r\n", Trivia::Kind::kLineEnd},    {"\n", Trivia::Kind::kLineEnd},
      {"#=\xFF", Trivia::Kind::kSkipped},  {";", Trivia::Kind::kComment}};
  std::string text;
  for (const auto& part : parts) text += part.first;
  std::string_view gap = text;
  for (const auto& [part, kind] : parts) {
    const Trivia trivia = first_trivia(gap);
    EXPECT_EQ(trivia.text, part);
    EXPECT_EQ(trivia.kind, kind);
    gap.remove_prefix(trivia.text.size());
  }
  EXPECT_TRUE(gap.empty());
}

TEST(ParseTree, KeepsWhatHasNoPlaceAsAnError) {
  Diagnostics diagnostics;
  const ParseTree tree = parse_tree("a.bhdl", "end state: name: \"s\" > 3 end", diagnostics);
  ASSERT_EQ(tree.nodes.size(), 5u);
  EXPECT_EQ(tree.nodes[0].kind, NodeKind::kError);
  EXPECT_EQ(tree.nodes[1].kind, NodeKind::kState);
  EXPECT_EQ(tree.nodes[2].kind, NodeKind::kAttribute);
  EXPECT_EQ(tree.nodes[3].kind, NodeKind::kValue);
  EXPECT_EQ(tree.nodes[4].kind, NodeKind::kError);
  EXPECT_EQ(tree.nodes[4].end_token - tree.nodes[4].first_token, 2u);
}

}  // namespace
}  // namespace galilean::bhdl
