// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/lexer.h"

#include <gtest/gtest.h>

namespace galilean::bhdl {
namespace {

struct Lexed {
  std::vector<Token> tokens;
  std::vector<Diagnostic> diagnostics;
};

Lexed lex(std::string_view text) {
  Diagnostics diagnostics;
  Lexer lexer("a.bhdl", text, diagnostics);
  Lexed result;
  for (Token token = lexer.next(); token.kind != TokenKind::kEndOfFile; token = lexer.next())
    result.tokens.push_back(token);
  result.diagnostics = std::move(diagnostics).take({"a.bhdl"});
  return result;
}

double number(std::string_view text) {
  const auto lexed = lex(text);
  EXPECT_EQ(lexed.tokens.size(), 1u) << text;
  EXPECT_TRUE(lexed.diagnostics.empty()) << text;
  return lexed.tokens.empty() ? 0 : lexed.tokens[0].number;
}

TEST(Lexer, ReadsEveryKindOfToken) {
  const auto tokens = lex("min_sphere: 30.5 <0,-1> (2) \"a b\"").tokens;
  using enum TokenKind;
  const std::vector<TokenKind> expected{kWord,   kColon,   kNumber,    kLess,   kNumber,     kComma,
                                        kNumber, kGreater, kLeftParen, kNumber, kRightParen, kText};
  ASSERT_EQ(tokens.size(), expected.size());
  for (std::size_t i = 0; i < tokens.size(); ++i) EXPECT_EQ(tokens[i].kind, expected[i]) << i;
  EXPECT_EQ(tokens.back().text, "a b");
}

TEST(Lexer, ReadsNumbersInEverySpelling) {
  EXPECT_EQ(number("30"), 30);
  EXPECT_EQ(number("30."), 30);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("1e3"), 1000);
  EXPECT_EQ(number("2.5E-1"), 0.25);
  EXPECT_EQ(number("-200"), -200);
}

TEST(Lexer, TakesADashForAMinus) {
  EXPECT_EQ(number("–200"), -200);
  EXPECT_EQ(number("−0.5"), -0.5);
  EXPECT_EQ(number("—7"), -7);
}

TEST(Lexer, TakesCurlyQuotesForQuotes) {
  for (const auto* text : {"“trash”", "”trash“", "„trash“", "“trash\"", "\"trash”"}) {
    const auto lexed = lex(text);
    ASSERT_EQ(lexed.tokens.size(), 1u) << text;
    EXPECT_EQ(lexed.tokens[0].text, "trash") << text;
    EXPECT_TRUE(lexed.diagnostics.empty()) << text;
  }
}

TEST(Lexer, CountsColumnsInCharactersAndLinesInEveryConvention) {
  const auto tokens = lex("“é” a\r\nb\rc\nd").tokens;
  ASSERT_EQ(tokens.size(), 5u);
  EXPECT_EQ(tokens[1].at.column, 5);
  EXPECT_EQ(tokens[2].at.line, 2);
  EXPECT_EQ(tokens[3].at.line, 3);
  EXPECT_EQ(tokens[4].at.line, 4);
}

TEST(Lexer, SkipsByteOrderMarkCommentsAndWideBlanks) {
  const auto tokens = lex("\uFEFFa ; b “c\n\u00A0d;e").tokens;
  ASSERT_EQ(tokens.size(), 2u);
  EXPECT_EQ(tokens[0].at.column, 1);
  EXPECT_EQ(tokens[1].text, "d");
}

TEST(Lexer, ReadsAUnitBehindANumberAndNowhereElse) {
  for (const auto* text : {"30cm/s", "30 cm/s", "30\n; so fast\ncm/s"}) {
    const auto tokens = lex(text).tokens;
    ASSERT_EQ(tokens.size(), 2u) << text;
    EXPECT_EQ(tokens[0].number, 30);
    EXPECT_EQ(tokens[1].text, "cm/s") << text;
  }
  EXPECT_EQ(lex("5 px^2 x").tokens[1].text, "px^2");
  EXPECT_EQ(lex("5 ticks/s^2 x").tokens[1].text, "ticks/s^2");
  EXPECT_EQ(lex("cm/s").diagnostics.size(), 1u);
  EXPECT_EQ(lex("5 cm /s").diagnostics.size(), 1u);
}

TEST(Lexer, ReportsWhatIsNoToken) {
  const auto lexed = lex("a = 3.0.1 \"open\n#!? b 1e999");
  ASSERT_EQ(lexed.diagnostics.size(), 5u);
  EXPECT_EQ(format(lexed.diagnostics[0]).substr(0, 48),
            "a.bhdl:1:3: error: the character '=' has no mean");
  EXPECT_EQ(lexed.diagnostics[1].code, "syntax/number");
  EXPECT_EQ(lexed.diagnostics[2].code, "syntax/unclosed-text");
  EXPECT_EQ(lexed.diagnostics[3].line, 2);
  EXPECT_EQ(lexed.diagnostics[4].code, "syntax/number");
  EXPECT_EQ(lexed.tokens.size(), 5u) << "the rest is still read";
}

}  // namespace
}  // namespace galilean::bhdl
