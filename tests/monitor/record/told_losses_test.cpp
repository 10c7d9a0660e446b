// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/told_losses.h"

#include <gtest/gtest.h>

#include "monitor/record/log_info.h"
#include "tests/monitor/record/faulty_disk.h"

namespace galilean::monitor {
namespace {

WriterLosses losses_of(const std::string& writer, std::uint64_t lost) {
  return {.topic = "/io/state", .process = "io", .writer = writer, .recorded = 10, .lost = lost};
}

class ToldLossesTest : public testing::Test {
 protected:
  ToldLossesTest() {
    EXPECT_TRUE(writer.begin());
    EXPECT_TRUE(writer.write(mcap::Metadata{"galilean", {{"version", "1"}}}));
  }
  std::optional<ToldLosses> told() const {
    const mcap::MemorySource source(disk.bytes());
    return told_losses(source, mcap::summarize(source).value());
  }

  mcap::FaultyDisk disk;
  mcap::Writer writer{disk};
  LossLog log{writer};
};

TEST_F(ToldLossesTest, AreThoseOfTheEndOfEachWriterEvenIfItsProcessHasTwo) {
  ASSERT_TRUE(log.tell({losses_of("a", 1)}, 500));
  ASSERT_TRUE(log.conclude({losses_of("a", 3), losses_of("b", 4), losses_of("c", 0)}));
  ASSERT_TRUE(writer.end());
  const auto losses = told().value();
  EXPECT_TRUE(losses.is_whole);
  EXPECT_EQ(losses.writers.size(), 2U);
  EXPECT_EQ(total_missing(losses.writers), 7U);
}

TEST_F(ToldLossesTest, OfARecorderThatBrokeOffAreTheNewestThatItTold) {
  ASSERT_TRUE(log.tell({losses_of("a", 1), losses_of("b", 1)}, 500));
  ASSERT_TRUE(log.tell({losses_of("a", 5), losses_of("b", 1)}, 600));
  ASSERT_TRUE(writer.close_chunk_if_due(10'000'000'000));
  const auto losses = told().value();
  EXPECT_FALSE(losses.is_whole);
  EXPECT_EQ(total_missing(losses.writers), 6U);
}

TEST_F(ToldLossesTest, OfALaterFileAreThoseSinceTheFileBefore) {
  ASSERT_TRUE(log.begin({losses_of("a", 3), losses_of("b", 4)}));
  ASSERT_TRUE(log.tell({losses_of("a", 3), losses_of("b", 4)}, 500));
  ASSERT_TRUE(log.conclude({losses_of("a", 3), losses_of("b", 6), losses_of("c", 1)}));
  ASSERT_TRUE(writer.end());
  EXPECT_EQ(writer.statistics().messages, 0U);
  const auto losses = told().value();
  ASSERT_EQ(losses.writers.size(), 2U);
  EXPECT_EQ(losses.writers[0].lost, 2U);
  EXPECT_EQ(losses.writers[1].lost, 1U);
}

TEST_F(ToldLossesTest, OfFilesThatWereMergedAreThoseOfAll) {
  ASSERT_TRUE(log.begin({losses_of("a", 1)}));
  ASSERT_TRUE(log.conclude({losses_of("a", 3), losses_of("b", 4)}));
  ASSERT_TRUE(LossLog(writer).begin({losses_of("a", 3), losses_of("b", 4)}));
  ASSERT_TRUE(LossLog(writer).conclude({losses_of("a", 7), losses_of("b", 4)}));
  ASSERT_TRUE(writer.end());
  const auto losses = told().value();
  EXPECT_TRUE(losses.is_whole);
  ASSERT_EQ(losses.writers.size(), 2U);
  EXPECT_EQ(losses.writers[0].lost, 6U);
  EXPECT_EQ(losses.writers[1].lost, 4U);
}

TEST_F(ToldLossesTest, AreToldOnlyWhenTheyGrow) {
  for (const std::int64_t now_ns : {500, 600, 700})
    ASSERT_TRUE(log.tell({losses_of("a", 1), losses_of("b", 0)}, now_ns));
  ASSERT_TRUE(writer.end());
  EXPECT_EQ(writer.statistics().messages, 1U);
}

TEST_F(ToldLossesTest, OfAProgramThatDoesNotCountThemAreUnknown) {
  ASSERT_TRUE(writer.end());
  EXPECT_FALSE(told().has_value());
  const auto text = describe("run.mcap", {}, std::nullopt);
  EXPECT_NE(text.find("missing:   unknown"), std::string::npos) << text;
}

}  // namespace
}  // namespace galilean::monitor
