// SPDX-License-Identifier: BSD-3-Clause
#include "core/cut_text.h"

#include <gtest/gtest.h>

#include <string>

#include "core/json_text.h"

namespace galilean {
namespace {

TEST(CutText, LeavesWhatFits) {
  EXPECT_EQ(cut_text("", 0), "");
  EXPECT_EQ(cut_text("io", 2), "io");
  EXPECT_EQ(cut_text("é", 2), "é");
  EXPECT_EQ(cut_text("🤖", 100), "🤖");
}

TEST(CutText, CutsWhereACharacterEnds) {
  EXPECT_EQ(cut_text("ganymede", 3), "gan");
  EXPECT_EQ(cut_text("aé", 2), "a");
  EXPECT_EQ(cut_text("aéb", 3), "aé");
  EXPECT_EQ(cut_text("木木", 5), "木");
  EXPECT_EQ(cut_text("🤖", 3), "");
  EXPECT_EQ(cut_text("é", 0), "");
}

TEST(CutText, OfATextInUtf8LeavesOneAtEveryLength) {
  const std::string text = "a é ∀ 木 🤖 “…” ß";
  for (std::size_t most = 0; most <= text.size() + 1; ++most) {
    const std::string_view cut = cut_text(text, most);
    EXPECT_LE(cut.size(), most);
    EXPECT_TRUE(text.starts_with(cut));
    EXPECT_TRUE(cut.size() == text.size() || cut.size() + 4 > most) << "no more than a character";
    EXPECT_TRUE(read_json(std::string("\"") + std::string(cut) + '"')) << "at " << most;
  }
}

TEST(CutText, CutsWhatIsNoUtf8Anywhere) {
  const std::string bytes(10, '\x80');
  EXPECT_EQ(cut_text(bytes, 7).size(), 7U);
  EXPECT_EQ(cut_text(bytes, 2).size(), 2U);
}

}  // namespace
}  // namespace galilean
