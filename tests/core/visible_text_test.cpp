// SPDX-License-Identifier: BSD-3-Clause
#include "core/visible_text.h"

#include <gtest/gtest.h>

namespace galilean {
namespace {

TEST(VisibleText, LeavesWhatCanBeSeenAsItIs) {
  for (const std::string text : {"", "io", "two words", "Überall ∀ 木 🤖", "…“”→", "~"})
    EXPECT_EQ(visible(text), text);
}

TEST(VisibleText, ShowsTheCodesOfWhatCannotBeSeen) {
  EXPECT_EQ(visible("i\u200Bo"), "iU+200Bo");
  EXPECT_EQ(visible("i\u00A0o"), "iU+00A0o");
  EXPECT_EQ(visible("\u202Eoi\u202C"), "U+202EoiU+202C");
  EXPECT_EQ(visible("\u2066\u2069\uFEFF\u00AD"), "U+2066U+2069U+FEFFU+00AD");
  EXPECT_EQ(visible("\x1B[31mred\a\r\n\t\x7F"), "U+001B[31mredU+0007U+000DU+000AU+0009U+007F");
  EXPECT_EQ(visible(std::string("a\0b", 3)), "aU+0000b");
  EXPECT_EQ(visible("\U000E0041\u009B"), "U+E0041U+009B");
  EXPECT_EQ(visible("\u1680\u2800\U0001D173"), "U+1680U+2800U+1D173");
}

TEST(VisibleText, ShowsTheBytesThatBreakUtf8) {
  EXPECT_EQ(visible("a\xFF"), "a0xFF");
  EXPECT_EQ(visible("\xE2\x80"), "0xE20x80");
  EXPECT_EQ(visible("\xC0\x80"), "0xC00x80");
  EXPECT_EQ(visible("\xED\xA0\x80"), "0xED0xA00x80");
}

TEST(VisibleText, ChangesNothingTwice) {
  const std::string once = visible("\u200B\x1B\xFF io");
  EXPECT_EQ(visible(once), once);
}

}  // namespace
}  // namespace galilean
