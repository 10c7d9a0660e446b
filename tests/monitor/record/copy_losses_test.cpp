// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/copy_losses.h"

#include <gmock/gmock.h>

namespace galilean::monitor {
namespace {

using testing::HasSubstr;

/// A recording of which a chunk with 10 states and 3 lines of a log is damaged, from 100 to 200 ns.
mcap::Summary with_a_damaged_chunk() {
  mcap::Summary summary;
  summary.checked = true;
  summary.channels[1].topic = "/io/state";
  summary.channels[2].topic = "/io/log";
  summary.statistics.end_ns = 9000;
  summary.lost = {{1, 10}, {2, 3}};
  summary.damages.push_back({.what = "the chunk at byte 5",
                             .offset = 5,
                             .time = mcap::TimeRange{100, 200},
                             .messages = 13,
                             .channel_messages = summary.lost});
  return summary;
}

CopyLosses losses_of(const mcap::Summary& summary, const CopiedPart& part = {}) {
  return losses_of_copying("/logs/dam.mcap", summary, summary.damages, part);
}

TEST(CopyLosses, AreReadAsTheyWereWritten) {
  const auto losses = losses_of(with_a_damaged_chunk());
  mcap::Summary copy;
  copy.metadata.push_back(metadata_of(losses));
  EXPECT_EQ(copy_losses(copy), std::vector{losses});
  EXPECT_EQ(copy_loss_text(losses),
            "13 messages are lost, which were damaged or missing in dam.mcap, the file that it was "
            "copied from (/io/log 3, /io/state 10)");
}

TEST(CopyLosses, OfAPartAreThoseOfItsTimeAndTopics) {
  const auto summary = with_a_damaged_chunk();
  EXPECT_EQ(losses_of(summary, {mcap::TimeRange{50, 300}, {}}).missing(), 13U);
  EXPECT_FALSE(losses_of(summary, {mcap::TimeRange{201, 300}, {}}).any());
  const auto across = losses_of(summary, {mcap::TimeRange{150, 300}, {}});
  EXPECT_TRUE(across.any());
  EXPECT_EQ(across.missing(), 0U) << "it is not known how many of the part are lost";
  const auto of_log =
      losses_of(summary, {{}, [](const auto& topic) { return topic == "/io/log"; }});
  EXPECT_EQ(of_log.missing(), 3U);
}

TEST(CopyLosses, OfAFileThatWasNotClosedAreBehindItsLastMessage) {
  mcap::Summary cut;
  cut.closed = false;
  cut.statistics.end_ns = 9000;
  const auto losses = losses_of(cut);
  EXPECT_FALSE(losses.is_exact);
  EXPECT_EQ(losses.times, (std::vector{mcap::TimeRange{9001, UINT64_MAX}}));
  EXPECT_FALSE(losses_of(cut, {mcap::TimeRange{50, 300}, {}}).any());
  cut.closed = true;
  EXPECT_FALSE(losses_of(cut).any());
}

TEST(CopyLosses, ThatCannotBeReadAreAnUnknownNumber) {
  mcap::Summary copy;
  copy.metadata.push_back({kCopyLossesMetadata, {{"topics", "[1"}, {"others", "x"}}});
  const auto losses = copy_losses(copy).at(0);
  EXPECT_TRUE(losses.any());
  EXPECT_THAT(copy_loss_text(losses), HasSubstr("an unknown number of messages is lost"));
}

}  // namespace
}  // namespace galilean::monitor
