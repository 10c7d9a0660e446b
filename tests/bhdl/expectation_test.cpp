// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "bhdl/diff/diff.h"
#include "bhdl/format/formatter.h"
#include "tests/bhdl/small_catalog.h"

namespace galilean::bhdl {
namespace {

constexpr const char* kMachine = "variables: bits: name: \"b\" end\nstate: name: \"s\" end\n";

Program program_expecting(const std::string& expectation) {
  auto result = check_text(kMachine + expectation);
  EXPECT_TRUE(result.program) << printed(result);
  return result.program.value_or(Program{});
}

TEST(Expectations, AreKeptApartFromWhatARobotDoes) {
  const auto program = program_expecting(
      "expect: name: \"e\" given: bits_variable: \"b\" bit_index: 3 from: 500 ms end "
      "stays: state: \"s\" from: 1 s until: 2 s end end");
  ASSERT_EQ(program.expectations.size(), 1u);
  const auto& expectation = program.expectations[0];
  EXPECT_EQ(expectation.name, "e");
  EXPECT_EQ(expectation.lasts_s, 2);
  ASSERT_EQ(expectation.givens.size(), 1u);
  EXPECT_EQ(expectation.givens[0].bit_index, 3u);
  EXPECT_EQ(expectation.givens[0].from_s, 0.5);
  ASSERT_EQ(expectation.claims.size(), 1u);
  EXPECT_EQ(expectation.claims[0].kind, Claim::Kind::kStays);
  EXPECT_TRUE(differences(program, program_expecting(""), small_catalog()).empty());
}

TEST(Expectations, MayUseConstants) {
  const auto program = program_expecting(
      "define: soon: 3 s end expect: name: \"e\" reaches: state: \"s\" by: soon end end");
  ASSERT_EQ(program.expectations.size(), 1u);
  EXPECT_EQ(program.expectations[0].claims[0].until_s, 3);
}

TEST(Expectations, AreLaidOut) {
  const auto result = format_text("program.bhdl",
                                  "expect: name: \"e\" lasts: 3 s given: bits_variable: \"b\" "
                                  "end\nreaches: state: \"s\" by: 2 s "
                                  "end ; soon\nend");
  ASSERT_TRUE(result.text);
  EXPECT_EQ(format_text("program.bhdl", *result.text).text, result.text);
  EXPECT_NE(result.text->find("; soon"), std::string::npos);
}

TEST(Expectations, AreClosedLikeStates) {
  EXPECT_EQ(
      summary(check_text(std::string(kMachine) + "expect: name: \"e\" never: state: \"s\" end")),
      "3:40 error syntax/unclosed\n");
}

}  // namespace
}  // namespace galilean::bhdl
