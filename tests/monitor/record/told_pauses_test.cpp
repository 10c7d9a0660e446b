// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/told_pauses.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/json_text.h"
#include "monitor/record/log_info.h"
#include "monitor/record/losses.h"
#include "monitor/record/paused_tally.h"
#include "tests/monitor/record/faulty_disk.h"

namespace galilean::monitor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Pause kBegun{.from_ns = 5'000'000'000, .to_ns = {}, .messages = 0, .by = "anna"};
const Pause kEnded{.from_ns = 5'000'000'000, .to_ns = 7'500'000'000, .messages = 9, .by = "anna"};

class ToldPausesTest : public testing::Test {
 protected:
  ToldPausesTest() {
    EXPECT_TRUE(writer.begin());
    EXPECT_TRUE(losses.begin({}));
  }
  std::vector<Pause> told() const {
    const mcap::MemorySource source(disk.bytes());
    return told_pauses(source, mcap::summarize(source).value());
  }
  void end_in_order() {
    ASSERT_TRUE(pauses.conclude());
    ASSERT_TRUE(losses.conclude({}));
    ASSERT_TRUE(writer.end());
  }

  mcap::FaultyDisk disk;
  mcap::Writer writer{disk};
  LossLog losses{writer};
  PauseLog pauses{writer};
};

TEST(Pause, IsReadAsItWasWritten) {
  for (const auto& pause : {kBegun, kEnded})
    EXPECT_EQ(read_pause(ordered_json_text(json_of(pause))), pause);
  for (const char* text : {"", "12", "{}", R"({"from_ns":"x"})", R"({"from_ns":"-1"})"})
    EXPECT_FALSE(read_pause(text).has_value()) << text;
}

TEST_F(ToldPausesTest, AreThoseOfTheEnd) {
  ASSERT_TRUE(pauses.tell(kBegun));
  ASSERT_TRUE(pauses.tell(kEnded));
  end_in_order();
  EXPECT_THAT(told(), ElementsAre(kEnded));
}

TEST_F(ToldPausesTest, OfARecorderThatBrokeOffAreThoseThatItTold) {
  ASSERT_TRUE(pauses.tell(kBegun));
  ASSERT_TRUE(writer.close_chunk_if_due(UINT64_MAX));
  EXPECT_THAT(told(), ElementsAre(kBegun));
  ASSERT_TRUE(pauses.tell(kEnded));
  ASSERT_TRUE(writer.close_chunk_if_due(UINT64_MAX));
  EXPECT_THAT(told(), ElementsAre(kEnded));
}

TEST_F(ToldPausesTest, AFileWithoutOneTellsNone) {
  end_in_order();
  EXPECT_EQ(writer.statistics().metadata, 2U);  // those of losses
  EXPECT_TRUE(told().empty());
}

TEST_F(ToldPausesTest, ThoseOfAnotherTimeAreLeftOut) {
  const auto channel = writer.add_channel({.topic = "/a", .message_encoding = "cdr"});
  ASSERT_TRUE(pauses.tell(kEnded));
  ASSERT_TRUE(pauses.conclude());
  mcap::FaultyDisk other;
  mcap::Writer slice(other);
  ASSERT_TRUE(slice.begin());
  ASSERT_EQ(slice.add_channel({.topic = "/a", .message_encoding = "cdr"}), channel);
  ASSERT_TRUE(slice.write(mcap::Message{channel, 1, 8'000'000'000, 0, {}}));
  ASSERT_TRUE(
      slice.write(mcap::Metadata{kPausesMetadata, {{"1", ordered_json_text(json_of(kEnded))}}}));
  ASSERT_TRUE(slice.end());
  const mcap::MemorySource source(other.bytes());
  EXPECT_TRUE(told_pauses(source, mcap::summarize(source).value()).empty());
}

TEST(PauseText, TellsWhoFromWhenToWhenAndHowMuch) {
  EXPECT_EQ(pause_text(kEnded),
            "paused by anna from 1970-01-01T00:00:05.000Z to 1970-01-01T00:00:07.500Z (2.5 s), 9 "
            "messages not recorded");
  EXPECT_EQ(pause_text(kBegun), "paused by anna from 1970-01-01T00:00:05.000Z on");
  EXPECT_THAT(describe("run.mcap", {}, std::nullopt, {kEnded}),
              HasSubstr("pause:     paused by anna from 1970-01-01T00:00:05.000Z to"));
}

TEST(PausedTally, WhatIsLostAtTheEdgesOfAPauseStaysLost) {
  wire::SequenceTally all;
  PausedTally paused;
  ASSERT_TRUE(all.note(1));
  ASSERT_TRUE(all.note(3));  // in the first pause; 2 may have been sent before it
  paused.note(1, all);
  ASSERT_TRUE(all.note(6));
  paused.note(1, all);
  EXPECT_EQ(paused.came(), 2U);
  EXPECT_EQ(paused.lost(), 2U);
  ASSERT_TRUE(all.note(8));  // in the second
  paused.note(2, all);
  EXPECT_EQ(paused.lost(), 2U);
  EXPECT_EQ(all.lost() - paused.lost(), 2U);
}

}  // namespace
}  // namespace galilean::monitor
