// SPDX-License-Identifier: BSD-3-Clause
// What strangers chose stands in sentences that others read: it is short, visible and whole UTF-8.
#include "robot/telemetry/order_words.h"

#include <gtest/gtest.h>

#include "core/json_text.h"

namespace galilean::robot {
namespace {

/// Returns whether the text is UTF-8, as messages and JSON need it.
bool is_utf8(const std::string& text) {
  return read_untrusted_json("\"" + text + "\"").ok();
}

TEST(OrderWords, AProgramIsNamedByTheBeginningOfItsHash) {
  msg::ProgramPush push;
  push.hash = "0123456789abcdef";
  EXPECT_EQ(what_is(push), "A push of program 01234567");
  msg::ProgramRollback order;
  order.hash = push.hash;
  EXPECT_EQ(what_is(order), "A rollback of program 01234567");
}

TEST(OrderWords, NoCharacterIsCutWhateverAStrangerChose) {
  for (const std::string letter : {"é", "木", "🤖"})
    for (std::size_t before = 0; before < 9; ++before) {
      std::string text(before, 'a');
      for (int i = 0; i < 40; ++i) text += letter;
      msg::ProgramPush push;
      push.hash = text;
      EXPECT_TRUE(is_utf8(what_is(push))) << what_is(push);
      msg::ProgramRollback rollback;
      rollback.hash = text;
      EXPECT_TRUE(is_utf8(what_is(rollback))) << what_is(rollback);
      msg::BreakOrder order;
      order.order = text;
      EXPECT_TRUE(is_utf8(what_is(order))) << what_is(order);
      EXPECT_TRUE(is_utf8(words_of(wire::Sender{text, text})))
          << words_of(wire::Sender{text, text});
    }
}

TEST(OrderWords, BytesThatAreNoTextAreShownByTheirValues) {
  msg::ProgramPush push;
  push.hash = "\xFF\n";
  EXPECT_EQ(what_is(push), "A push of program 0xFFU+000A");
  EXPECT_TRUE(is_utf8(words_of(wire::Sender{"\xC3", ""})));
}

}  // namespace
}  // namespace galilean::robot
