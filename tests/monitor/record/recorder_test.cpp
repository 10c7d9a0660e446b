// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recorder.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/monitor/record/recorder_fixture.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;
using wire::Delivery;
using wire::Foreign;
using wire::wait_until;

TEST_F(RecorderTest, ATypeOfSomebodyElseIsRecordedWithItsDefinition) {
  auto cells = talk(Foreign::kCells, "rt/cells");
  ASSERT_TRUE(cells.write());
  start();
  ASSERT_TRUE(comes_to_record(1));
  const auto summary = recorded();
  ASSERT_EQ(summary.schemas.size(), 1U);
  EXPECT_EQ(summary.schemas.begin()->second.encoding, "ros2msg");
  EXPECT_EQ(summary.schemas.begin()->second.data, "int8 cost\nint8[] costs\nint8[4] corners\n");
  EXPECT_EQ(summary.channels.begin()->second.topic, "/cells");
  EXPECT_EQ(warnings, "");
}

TEST_F(RecorderTest, WhatNoMsgFileCanSayIsDefinedInIdl) {
  auto plain = talk(Foreign::kPlain, "rt/plain");
  ASSERT_TRUE(plain.write());
  start();
  ASSERT_TRUE(comes_to_record(1));
  const auto summary = recorded();
  ASSERT_EQ(summary.schemas.size(), 1U);
  EXPECT_EQ(summary.schemas.begin()->second.encoding, "omgidl");
  EXPECT_THAT(summary.schemas.begin()->second.data, HasSubstr("struct Plain {"));
}

TEST_F(RecorderTest, AnEncodingThatIsNotRosIsDefinedInIdl) {
  wire::ForeignTalk cells(process.participant(), Foreign::kCells, "rt/cells", wire::Cdr::kSecond);
  ASSERT_TRUE(cells.write());
  start();
  ASSERT_TRUE(comes_to_record(1));
  const auto summary = recorded();
  ASSERT_EQ(summary.schemas.size(), 1U);
  EXPECT_EQ(summary.schemas.begin()->second.encoding, "omgidl");
}

TEST_F(RecorderTest, WithoutTypeInformationTheBytesAreRecordedAndThatIsSaid) {
  auto bare = talk(Foreign::kBare, "rt/bare");
  ASSERT_TRUE(bare.write());
  start();
  ASSERT_TRUE(comes_to_record(1));
  const auto summary = recorded();
  ASSERT_EQ(summary.channels.size(), 1U);
  EXPECT_EQ(summary.channels.begin()->second.schema_id, 0);
  EXPECT_EQ(summary.channels.begin()->second.metadata.at("type"), "bare::Message");
  EXPECT_THAT(warnings, HasSubstr("'/bare' is recorded as bytes that no reader can decode"));
}

TEST_F(RecorderTest, ALaterWriterOfAnotherTypeHasAChannelOfItsOwn) {
  auto cells = talk(Foreign::kCells, "rt/mixed");
  ASSERT_TRUE(cells.write());
  start();
  ASSERT_TRUE(comes_to_record(1));
  auto large = talk(Foreign::kLarge, "rt/mixed");
  ASSERT_TRUE(large.write());
  ASSERT_TRUE(comes_to_record(2));
  EXPECT_EQ(recorder->recordings().topics(), 1U);
  const auto summary = recorded();
  EXPECT_EQ(summary.channels.size(), 2U);
  for (const auto& [id, channel] : summary.channels) EXPECT_EQ(channel.topic, "/mixed");
}

TEST_F(RecorderTest, EachWriterOfATopicHasAChannelInWhichItsNumbersRise) {
  auto first = talk(Foreign::kCells, "rt/cells", Delivery::kFlow);
  auto second = talk(Foreign::kCells, "rt/cells", Delivery::kFlow);
  start();
  ASSERT_TRUE(comes_to_be_heard(first));
  ASSERT_TRUE(comes_to_be_heard(second));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(first.write());
  ASSERT_TRUE(comes_to_record(3));
  ASSERT_TRUE(second.write());
  ASSERT_TRUE(comes_to_record(4));
  const auto summary = recorded();
  ASSERT_EQ(summary.channels.size(), 2U);
  EXPECT_EQ(summary.schemas.size(), 1U);
  const auto& channels = summary.channels;
  EXPECT_EQ(channels.at(1).metadata.at("process"), "talker");
  EXPECT_NE(channels.at(1).metadata.at("writer"), channels.at(2).metadata.at("writer"));
  EXPECT_FALSE(channels.at(1).metadata.contains(kSequenceGaps));
  EXPECT_EQ(summary.statistics.channel_messages.at(1), 3U);
  EXPECT_EQ(summary.statistics.channel_messages.at(2), 1U);
}

TEST_F(RecorderTest, AChannelSaysWhereItsNumbersSkipThoughNothingIsMissing) {
  auto keyed = talk(Foreign::kKeyed, "rt/keyed");
  ASSERT_TRUE(keyed.write());
  start();
  ASSERT_TRUE(comes_to_record(1));
  const auto summary = recorded();
  ASSERT_EQ(summary.channels.size(), 1U);
  EXPECT_TRUE(summary.channels.begin()->second.metadata.contains(kSequenceGaps));
}

TEST_F(RecorderTest, AChannelTellsWhatItsWriterOffers) {
  auto stream = talk(Foreign::kCells, "rt/stream", Delivery::kStream);
  start();
  ASSERT_TRUE(comes_to_be_heard(stream));
  ASSERT_TRUE(stream.write());
  ASSERT_TRUE(comes_to_record(1));
  const auto summary = recorded();
  ASSERT_EQ(summary.channels.size(), 1U);
  const auto& told = summary.channels.begin()->second.metadata.at("offered_qos_profiles");
  EXPECT_THAT(told, HasSubstr("reliability: best_effort"));
  EXPECT_THAT(told, HasSubstr("durability: volatile"));
}

TEST_F(RecorderTest, KnowsThatASelectionLeftAllOut) {
  const auto cells = talk(Foreign::kCells, "rt/cells");
  Selection selection;
  selection.topics.emplace_back("^/io/");
  start(std::move(selection));
  EXPECT_TRUE(wait_until([&] { return pump(), recorder->recordings().left_out_topics(); }));
  EXPECT_EQ(recorder->recordings().topics(), 0U);
}

TEST_F(RecorderTest, WhatItsQueueDroppedStandsInTheFile) {
  auto cells = talk(Foreign::kCells, "rt/cells");
  start();
  ASSERT_TRUE(comes_to_be_heard(cells));
  ASSERT_TRUE(cells.write());
  ASSERT_TRUE(comes_to_record(1));
  for (int i = 0; i < 700; ++i) ASSERT_TRUE(cells.write());  // 600 wait at most
  ASSERT_TRUE(cells.arrived());
  ASSERT_TRUE(wait_until([&] {
    pump();
    const auto losses = recorder->recordings().losses();
    return losses.front().recorded + losses.front().missing() == 701;
  }));
  const auto missing = total_missing(recorder->recordings().losses());
  EXPECT_GT(missing, 0U);
  look();
  const auto summary = recorded();
  const auto losses = std::ranges::find(summary.metadata, "losses", &mcap::Metadata::name);
  ASSERT_NE(losses, summary.metadata.end());
  EXPECT_EQ(losses->entries.at("missing"), std::to_string(missing));
  EXPECT_THAT(losses->entries.at("/cells of talker"), HasSubstr("\"sent_before\":0"));
  EXPECT_TRUE(std::ranges::any_of(summary.channels, [](const auto& channel) {
    return channel.second.topic == "/recorder/losses";
  }));
}

}  // namespace
}  // namespace galilean::monitor
