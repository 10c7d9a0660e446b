// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/damage_text.h"

#include <gmock/gmock.h>

#include "monitor/record/times.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;

mcap::Summary with_two_channels() {
  mcap::Summary summary;
  summary.channels[1].topic = "/io/state";
  summary.channels[2].topic = "/io/log";
  return summary;
}

constexpr std::uint64_t kTime_ns = 1'700'000'000'000'000'000;

TEST(DamageText, SaysTimeNumberAndTopics) {
  const mcap::Damage damage{.what = "the chunk at byte 17 cannot be decompressed",
                            .offset = 17,
                            .time = mcap::TimeRange{kTime_ns, kTime_ns + 1'500'000'000},
                            .messages = 12,
                            .channel_messages = {{1, 9}, {7, 3}}};
  EXPECT_EQ(
      damage_text(damage, with_two_channels()),
      "the chunk at byte 17 cannot be decompressed: 12 messages from 2023-11-14T22:13:20.000Z to "
      "2023-11-14T22:13:21.500Z are lost (/io/state 9, channel 7 3)");
}

TEST(DamageText, SaysWhatIsNotKnownAndWhatLosesNothing) {
  const auto summary = with_two_channels();
  EXPECT_EQ(damage_text({.what = "the record at byte 9 is of no kind"}, summary),
            "the record at byte 9 is of no kind: an unknown number of messages is lost");
  EXPECT_EQ(damage_text({.what = "the summary at byte 9 cannot be read", .messages = 0}, summary),
            "the summary at byte 9 cannot be read; no message is lost by it");
}

TEST(DamageText, AFileThatIsBeingWrittenIsNotCalledDamaged) {
  auto summary = with_two_channels();
  EXPECT_EQ(condition_text("run.mcap", summary), "");
  summary.closed = false;
  summary.being_written = true;
  summary.statistics.messages = 5;
  EXPECT_EQ(condition_text("run.mcap", summary),
            "run.mcap is being written; it has 5 messages so far\n");
  summary.being_written = false;
  EXPECT_THAT(condition_text("run.mcap", summary),
              HasSubstr("run.mcap was not closed properly; recovered 5 messages\n"));
}

TEST(DamageText, AThousandDamagesAreNotAThousandLines) {
  auto summary = with_two_channels();
  summary.damages.resize(1000);
  EXPECT_THAT(condition_text("run.mcap", summary),
              HasSubstr("and 980 damages more; --json lists all\n"));
}

TEST(Times, AreToldInTheUnitThatFits) {
  EXPECT_EQ(time_span(5.94), "5.9 s");
  EXPECT_EQ(time_span(720), "12.0 min");
  EXPECT_EQ(time_span(54 * 365.25 * 86400), "54.0 years");
  EXPECT_EQ(iso_time(UINT64_MAX), "2554-07-21T23:34:33.709Z");
}

}  // namespace
}  // namespace galilean::monitor
