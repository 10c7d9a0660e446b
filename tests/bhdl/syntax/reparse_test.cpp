// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/reparse.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/bhdl/random_program.h"

namespace galilean::bhdl {
namespace {

constexpr std::string_view kFile = "program.bhdl";

Reading whole(const std::string& text) {
  return read_text(kFile, text);
}

std::string faults_of(Reading reading) {
  std::string all;
  for (const auto& each : std::move(reading.faults).take({std::string(kFile)}))
    all += format(each) + '\n';
  return all;
}

void expect_same(const Token& a, const ParseTree& in_a, const Token& b, const ParseTree& in_b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.open_quote, b.open_quote);
  EXPECT_EQ(a.close_quote, b.close_quote);
  EXPECT_EQ(a.at.line, b.at.line);
  EXPECT_EQ(a.at.column, b.at.column);
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.text, b.text);
  EXPECT_EQ(in_a.offset_of(a.text), in_b.offset_of(b.text));
}

void expect_same(const ParseTree& a, const ParseTree& b) {
  ASSERT_EQ(a.tokens.size(), b.tokens.size());
  for (std::size_t i = 0; i < a.tokens.size(); ++i) expect_same(a.tokens[i], a, b.tokens[i], b);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    EXPECT_EQ(a.nodes[i].kind, b.nodes[i].kind) << i;
    EXPECT_EQ(a.nodes[i].sense, b.nodes[i].sense) << i;
    EXPECT_EQ(a.nodes[i].first_token, b.nodes[i].first_token) << i;
    EXPECT_EQ(a.nodes[i].end_token, b.nodes[i].end_token) << i;
    EXPECT_EQ(a.nodes[i].end_node, b.nodes[i].end_node) << i;
  }
}

void expect_same(const Reading& a, const Reading& b) {
  expect_same(a.tree, b.tree);
  EXPECT_EQ(faults_of(a), faults_of(b));
}

std::string states(int count, const std::string& between) {
  std::string text = "variables: bits: name: \"b\" end\nstates:\n";
  for (int i = 0; i < count; ++i)
    text += "state: name: \"s" + std::to_string(i) + "\" motor_schemas: \"a\" end\n" + between +
            " condition: bit_index: 3 new_state: \"s0\" end end\n";
  return text + "end\ndefine: far: 3 m end start_state: \"s0\"\n";
}

/// A text with a word or a letter put in or taken away somewhere.
std::string edited(std::string text, RandomProgram& random) {
  static const std::array<std::string, 14> kPieces{"\"",
                                                   "a",
                                                   "end",
                                                   ":",
                                                   "state: name: \"n\" end\n",
                                                   " ",
                                                   ";",
                                                   "\n",
                                                   "end states:\n",
                                                   "3 m",
                                                   "e3",
                                                   "\r",
                                                   "states:\n",
                                                   "“"};
  const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size() + 1)));
  if (random.chance()) return text.erase(at, static_cast<std::size_t>(random.below(30)));
  return text.insert(at, random.one_of(kPieces));
}

TEST(Reparse, GivesTheTreeAndTheFaultsOfTheWholeText) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    RandomProgram random(seed);
    std::string text = seed % 3 == 0   ? random.program()
                       : seed % 3 == 1 ? states(12, seed % 2 == 0 ? "" : "; a comment\n")
                                       : damaged(states(8, ""), random);
    Reading reading = whole(text);
    for (int edit = 0; edit < 4; ++edit) {
      const std::string next = edited(text, random);
      const Reading next_reading = reread(reading, kFile, next);
      expect_same(next_reading, whole(next));
      if (testing::Test::HasFailure())
        FAIL() << "seed " << seed << '\n' << text << "\n---\n" << next;
      text = next;
      reading = reread(next_reading, kFile, text);
    }
  }
}

// What is not read again is copied, word for word: the earlier tree is not what the text says here.
TEST(Reparse, ReadsOnlyWhatTheEditTouches) {
  const std::string text = states(100, "");
  Reading reading = whole(text);
  ParseTree& tree = reading.tree;
  for (const std::uint32_t node : {3u, static_cast<std::uint32_t>(tree.nodes.size() - 3)})
    tree.nodes[node].sense = 77;
  std::string next = text;
  next.insert(text.find("\"s50\""), "x ");
  const Reading next_reading = reread(reading, kFile, next);
  const ParseTree& next_tree = next_reading.tree;
  EXPECT_EQ(next_tree.nodes[3].sense, 77);
  EXPECT_EQ(next_tree.nodes[next_tree.nodes.size() - 3].sense, 77);
}

// Each letter of a word that is wrong until it is whole.
TEST(Reparse, ReadsOnlyWhatIsWrongAgain) {
  std::string text = states(100, "");
  text.insert(text.find("condition", text.find("\"s50\"")), "x ");
  Reading reading = whole(text);
  ASSERT_GT(reading.faults.count(), 0u);
  reading.tree.nodes[3].sense = 77;
  const std::size_t last = reading.tree.nodes.size() - 3;
  reading.tree.nodes[last].sense = 78;
  std::string next = text;
  next.erase(text.find("x condition"), 2);
  const Reading corrected = reread(reading, kFile, next);
  EXPECT_EQ(corrected.faults.count(), 0u);
  EXPECT_EQ(corrected.tree.nodes[3].sense, 77);
  EXPECT_EQ(corrected.tree.nodes[corrected.tree.nodes.size() - 3].sense, 78);
}

TEST(Reparse, OfTheSameTextAndOfNoneIsTheirTree) {
  const std::string text = states(3, "");
  expect_same(reread(whole(text), kFile, text), whole(text));
  expect_same(reread(whole(text), kFile, ""), whole(""));
  expect_same(reread(whole(""), kFile, text), whole(text));
}

}  // namespace
}  // namespace galilean::bhdl
