// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/keys.h"

#include <gtest/gtest.h>

#include <vector>

namespace galilean::monitor::top {
namespace {

std::vector<Press> presses(KeyReader& reader, bool is_all = true) {
  std::vector<Press> all;
  for (Press press = reader.take(is_all); press.key != Key::kNone; press = reader.take(is_all))
    all.push_back(press);
  return all;
}

std::vector<Press> presses(std::string_view bytes) {
  KeyReader reader;
  reader.feed(bytes);
  return presses(reader);
}

TEST(Keys, LettersAndTheirNeighbours) {
  EXPECT_EQ(presses("a.\r\t\x7f"), (std::vector<Press>{{Key::kLetter, 'a'},
                                                       {Key::kLetter, '.'},
                                                       {Key::kEnter},
                                                       {Key::kTab},
                                                       {Key::kBackspace}}));
}

TEST(Keys, ArrowsAsBothKindsOfTerminalSendThem) {
  EXPECT_EQ(
      presses("\x1b[A\x1b[B\x1bOC\x1bOD\x1b[1;5A"),
      (std::vector<Press>{{Key::kUp}, {Key::kDown}, {Key::kRight}, {Key::kLeft}, {Key::kUp}}));
  EXPECT_EQ(presses("\x1b[5~\x1b[6~\x1b[H\x1b[4~"),
            (std::vector<Press>{{Key::kPageUp}, {Key::kPageDown}, {Key::kHome}, {Key::kEnd}}));
}

TEST(Keys, AClickTellsItsCellAndTheWheelItsDirection) {
  EXPECT_EQ(presses("\x1b[<0;12;3M\x1b[<0;12;3m\x1b[<64;1;2M\x1b[<65;200;60M"),
            (std::vector<Press>{{Key::kClick, 0, 2, 11},
                                {Key::kOther},
                                {Key::kWheelUp, 0, 1, 0},
                                {Key::kWheelDown, 0, 59, 199}}));
}

TEST(Keys, ASequenceMayComeInPieces) {
  KeyReader reader;
  reader.feed("\x1b");
  EXPECT_EQ(reader.take(false), Press{});
  EXPECT_TRUE(reader.is_pending());
  reader.feed("[");
  EXPECT_EQ(reader.take(false), Press{});
  reader.feed("B");
  EXPECT_EQ(reader.take(false), Press{Key::kDown});
  EXPECT_FALSE(reader.is_pending());
}

TEST(Keys, EscapeAloneIsAKey) {
  EXPECT_EQ(presses("\x1b"), std::vector<Press>{{Key::kEscape}});
  EXPECT_EQ(presses("\x1b\x1b[A"), (std::vector<Press>{{Key::kEscape}, {Key::kUp}}));
}

TEST(Keys, StopIsReadWhateverStandsBeforeIt) {
  const Press stop{Key::kLetter, '.'};
  EXPECT_EQ(presses("\x1b."), (std::vector<Press>{{Key::kEscape}, stop}));
  for (const char* begun : {"\x1bO", "\x1b[", "\x1b[1;"}) {
    const auto read = presses(std::string(begun) + ".");
    ASSERT_FALSE(read.empty());
    EXPECT_EQ(read.back(), stop) << begun;
  }
  EXPECT_EQ(presses("\x18\x1b\x18"),
            (std::vector<Press>{{Key::kStop}, {Key::kEscape}, {Key::kStop}}));
}

TEST(Keys, AnOldMouseReportIsSwallowed) {
  EXPECT_EQ(presses("\x1b[M .qs"), (std::vector<Press>{{Key::kOther}, {Key::kLetter, 's'}}));
  KeyReader reader;
  reader.feed("\x1b[M .");
  EXPECT_EQ(reader.take(false), Press{});
  reader.feed("q");
  EXPECT_EQ(presses(reader), std::vector<Press>{{Key::kOther}});
  reader.feed("\x1b[M ");
  EXPECT_EQ(presses(reader), std::vector<Press>{{Key::kOther}});
}

TEST(Keys, WhateverIsSentIsTakenToItsEnd) {
  std::string bytes;
  for (int i = 0; i < 5000; ++i) bytes += static_cast<char>(i * 7919 >> 3);
  bytes += "\x1b[" + std::string(500, '1');
  KeyReader reader;
  reader.feed(bytes);
  for (std::size_t taken = 0; reader.is_pending(); ++taken) {
    ASSERT_NE(reader.take(true).key, Key::kNone);
    ASSERT_LE(taken, bytes.size());
  }
}

}  // namespace
}  // namespace galilean::monitor::top
