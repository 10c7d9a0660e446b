// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/bhdl/random_program.h"
#include "tests/bhdl/small_catalog.h"

// Programs that a generator makes, and what becomes of them when they are damaged.

namespace galilean::bhdl {
namespace {

// A position may also be the one behind the last character, or behind the last line's end.
void expect_inside(const Diagnostic& diagnostic, const std::string& text) {
  std::vector<int> widths{0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool ends =
        text[i] == '\n' || (text[i] == '\r' && !(i + 1 < text.size() && text[i + 1] == '\n'));
    if (ends)
      widths.push_back(0);
    else
      ++widths.back();
  }
  EXPECT_EQ(diagnostic.file, "program.bhdl");
  ASSERT_GE(diagnostic.line, 1);
  ASSERT_LE(diagnostic.line, static_cast<int>(widths.size())) << format(diagnostic);
  EXPECT_GE(diagnostic.column, 1);
  EXPECT_LE(diagnostic.column, widths[static_cast<std::size_t>(diagnostic.line) - 1] + 1)
      << format(diagnostic);
}

TEST(RandomPrograms, AreRead) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const std::string text = RandomProgram(seed).program();
    const auto result = check_text(text);
    ASSERT_TRUE(result.program) << "seed " << seed << '\n' << printed(result) << text;
  }
}

TEST(RandomPrograms, GiveAnswersWithPlacesWhenDamaged) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    RandomProgram random(seed);
    const std::string text = damaged(random.program(), random);
    const auto result = check_text(text);
    EXPECT_EQ(result.program.has_value(), !any_error(result.diagnostics)) << seed;
    for (const auto& diagnostic : result.diagnostics) {
      expect_inside(diagnostic, text);
      EXPECT_FALSE(diagnostic.code.empty());
      EXPECT_FALSE(diagnostic.message.empty());
    }
    if (testing::Test::HasFailure()) FAIL() << "seed " << seed << '\n' << text;
  }
}

TEST(RandomPrograms, GiveTheSameAnswerTwice) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    RandomProgram random(seed);
    const std::string text = damaged(random.program(), random);
    EXPECT_EQ(printed(check_text(text)), printed(check_text(text)));
  }
}

}  // namespace
}  // namespace galilean::bhdl
