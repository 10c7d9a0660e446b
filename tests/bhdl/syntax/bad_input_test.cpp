// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "bhdl/syntax/loader.h"
#include "bhdl/syntax/parser.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

using testing::HasSubstr;

std::string repeated(const std::string& text, std::size_t bytes) {
  std::string result;
  result.reserve(bytes + text.size());
  while (result.size() + text.size() <= bytes) result += text;
  return result;
}

TEST(BadInput, ABinaryFileIsRefusedAtItsFirstByte) {
  using namespace std::string_literals;
  EXPECT_EQ(summary(check_text("state:\n  \0 name"s)), "2:3 error file/binary\n");
  EXPECT_EQ(summary(check_text("\x7f"
                               "ELF")),
            "1:1 error file/binary\n");
  const auto result = check_text("a\x1b[31m");
  EXPECT_EQ(printed(result),
            "program.bhdl:1:2: error: this is not a text: it holds the byte 0x1B\n"
            "  hint: save the file as UTF-8 text\n");
}

TEST(BadInput, WhatIsNotUtf8IsRefusedWhereItBegins) {
  for (const auto* bad :
       {"\x93trash\x94", "\xC3(", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80",
        "\xF8\x88\x80\x80\x80", "\xE2\x80", "\xF0\x80\x80\x80"})
    EXPECT_EQ(summary(check_text(std::string("; é\n “ ") + bad)), "2:4 error file/not-utf8\n");
}

TEST(BadInput, ATooLargeTextIsRefused) {
  EXPECT_EQ(summary(check_text(std::string(kMostFileBytes + 1, ' '))),
            "1:1 error file/too-large\n");
}

TEST(BadInput, NoFileAtAllIsAnError) {
  const auto result = check({}, small_catalog());
  EXPECT_FALSE(result.program);
  EXPECT_TRUE(any_error(result.diagnostics));
}

// Each fills the largest file with what might recurse, nest or take more than linear time.
TEST(BadInput, LargeFilesOfAnyKindAreAnswered) {
  const std::vector<std::string> kinds{"x",
                                       ": ",
                                       "<",
                                       "a:",
                                       "end ",
                                       "\"",
                                       "1 ",
                                       "state:",
                                       "a: 1 ",
                                       "“a” ",
                                       "condition: ",
                                       "<1,",
                                       "; comment",
                                       "states: ",
                                       "é",
                                       "a: b: c:",
                                       "include \"x\" ",
                                       "on_swap: \"a\": \"b\" ",
                                       "motor_schemas: ",
                                       ", "};
  for (const auto& kind : kinds) {
    const auto result = check_text(repeated(kind, kMostFileBytes));
    EXPECT_FALSE(result.program) << kind;
    EXPECT_LE(result.diagnostics.size(), 101u) << kind;
  }
}

TEST(BadInput, LargeListsAndManyNamesAreAnswered) {
  std::string names;
  for (int i = 0; names.size() < kMostFileBytes - 1000; ++i)
    names += "\"n" + std::to_string(i) + "\" ";
  const auto lists = check_text("state: name: \"s\" motor_schemas: " + names + "end end");
  EXPECT_EQ(lists.diagnostics.size(), 101u);

  std::string states;
  for (int i = 0; states.size() < kMostFileBytes - 1000; ++i)
    states +=
        "state: name: \"a_state_with_a_long_name_" + std::to_string(i) +
        "\" condition: bits_variable: \"b\" new_state: \"a_state_with_a_logn_name\" end end\n";
  EXPECT_EQ(check_text(states).diagnostics.size(), 101u);
}

std::string many(int count, const std::function<std::string(int)>& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text(i);
  return all;
}

std::string chain_of_states(int states) {
  return many(states, [](int i) {
    return "state: name: \"s" + std::to_string(i) +
           "\" condition: bits_variable: \"b\" new_state: \"s" + std::to_string(i + 1) +
           "\" end end\n";
  });
}

// What takes more than linear time takes minutes here. Sanitizers look at what is done for each
// state, which is the same for a tenth of them.
TEST(BadInput, AMillionStatesAreParsedAndRefusedByTheirSize) {
  constexpr int kStates = GALILEAN_SANITIZED ? 100'000 : 1'000'000;
  const std::string text = "variables: bits: name: \"b\" end\n" + chain_of_states(kStates);
  Diagnostics diagnostics;
  EXPECT_EQ(parse("program.bhdl", text, diagnostics).size(), kStates + 1u);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(summary(check_text(text)), "1:1 error file/too-large\n");
}

TEST(BadInput, AsManyStatesAsFitAreChecked) {
  const int states = 5000;
  const auto result = check_text("variables: bits: name: \"b\" end\n" + chain_of_states(states) +
                                 "state: name: \"s" + std::to_string(states) + "\" end");
  ASSERT_TRUE(result.program) << printed(result);
  EXPECT_EQ(result.program->states.size(), 5001u);
}

TEST(BadInput, AHundredThousandErrorsAreCounted) {
  const auto result = check_text(repeated("a ", 200'000));
  EXPECT_LE(result.diagnostics.size(), 101u);
  const auto each =
      check_text("state: name: \"s\" motor_schemas: " + many(60'000, [](int) { return "\"x\" "; }) +
                 "end end");
  EXPECT_EQ(each.diagnostics.size(), 101u);
  EXPECT_EQ(each.diagnostics.back().code, "too-many");
}

TEST(BadInput, DoubledAttributesAreInheritedInLinearTime) {
  const std::string doubled = repeated("persistence: 1 ", kMostFileBytes / 2 - 1000);
  const auto result = check_text("motor_schemas: noise: name: \"a\" " + doubled +
                                 "end noise: name: \"b\" extends: \"a\" " + doubled + "end end");
  EXPECT_EQ(result.diagnostics.size(), 101u);
}

TEST(BadInput, BasesThatDoNotExistAreAnswered) {
  const auto result = check_text(many(10'000, [](int i) {
    return "state: name: \"s" + std::to_string(i) + "\" extends: \"t\" end\n";
  }));
  EXPECT_EQ(result.diagnostics.size(), 101u);
}

TEST(BadInput, ManyFilesAndIncludesAreAnswered) {
  std::vector<SourceFile> files{{"main.bhdl", repeated("include \"none\" ", 300'000)}};
  for (int i = 0; i < 10'000; ++i) files.push_back({std::to_string(i), ""});
  EXPECT_EQ(check(files, small_catalog()).diagnostics.size(), 101u);
}

TEST(BadInput, OneEndlessLineHasColumns) {
  const auto result = check_text("state: name: \"s\" end " + repeated("; x\u00e9", 1000) +
                                 std::string(400'000, ' ') + "\nx");
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_EQ(result.diagnostics[0].line, 2);
  const auto behind = check_text("state: name: \"s\" end " + std::string(400'000, ' ') + "x");
  ASSERT_EQ(behind.diagnostics.size(), 1u);
  EXPECT_EQ(behind.diagnostics[0].column, 400'022);
}

TEST(BadInput, LineEndsAndAByteOrderMarkChangeNothing) {
  const std::string text =
      "variables: bits: name: \"b\" end\nstate: name: \"s\" motor_schemas: \"x\" end end";
  const auto with_line_ends = [&](const std::string& end) {
    std::string changed = text;
    changed.replace(text.find('\n'), 1, end);
    return changed;
  };
  const std::string expected = summary(check_text(text));
  EXPECT_EQ(expected, "2:33 error name/undefined-schema\n");
  EXPECT_EQ(summary(check_text(text + "\n")), expected);
  EXPECT_EQ(summary(check_text(with_line_ends("\r\n"))), expected);
  EXPECT_EQ(summary(check_text(with_line_ends("\r"))), expected);
  EXPECT_EQ(summary(check_text("\uFEFF" + text)), expected);
}

TEST(BadInput, LongNamesAreCutInMessages) {
  const auto result = check_text(std::string(1000, 'x') + ": " + std::string(500, 'y') + ": end");
  ASSERT_EQ(result.diagnostics.size(), 1u);
  EXPECT_LT(result.diagnostics[0].message.size(), 150u);
  EXPECT_THAT(result.diagnostics[0].message, HasSubstr("…"));
}

}  // namespace
}  // namespace galilean::bhdl
