// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/encoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace galilean::monitor::top {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr Look kPlainLook{};

Canvas screen_with(std::string_view text) {
  Canvas canvas(20, 3);
  canvas.put(1, 2, text);
  return canvas;
}

TEST(Encoder, TheFirstScreenIsDrawnOnAClearedTerminal) {
  EXPECT_EQ(changes(nullptr, screen_with("io"), kPlainLook),
            "\x1b[0m\x1b[2J\x1b[2;3H\x1b[0mio\x1b[0m");
}

TEST(Encoder, OnlyCellsThatDifferAreSent) {
  const Canvas before = screen_with("tick 31"), now = screen_with("tick 38");
  EXPECT_EQ(changes(&before, now, kPlainLook), "\x1b[2;9H\x1b[0m8\x1b[0m");
  EXPECT_EQ(changes(&now, now, kPlainLook), "");
}

TEST(Encoder, AnotherStyleIsAChange) {
  const Canvas before = screen_with("io");
  Canvas now = before;
  now.put(1, 2, "io", Style::kBold);
  EXPECT_EQ(changes(&before, now, kPlainLook), "\x1b[2;3H\x1b[0;1mio\x1b[0m");
}

TEST(Encoder, AWindowOfAnotherSizeIsDrawnWhole) {
  const Canvas before = screen_with("io"), now(30, 3);
  EXPECT_THAT(changes(&before, now, kPlainLook), StartsWith("\x1b[0m\x1b[2J"));
}

TEST(Encoder, WhereTheLocaleHasNoUtf8NothingElseThanAsciiIsSent) {
  Canvas canvas(120, 2);
  canvas.put(0, 0, "▶io→±0.10m90°▁▃▇█·─│├└⠿⣿31µ…");
  const std::string bytes = changes(nullptr, canvas, {Colours::kNone, true});
  for (const char byte : bytes) EXPECT_EQ(byte & 0x80, 0);
  EXPECT_THAT(bytes, HasSubstr(">io>+0.10m90d_-##.-|++**31u~"));
  EXPECT_THAT(bytes, Not(HasSubstr("?")));
}

}  // namespace
}  // namespace galilean::monitor::top
