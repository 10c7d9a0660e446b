// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/topic_recording.h"

#include <gtest/gtest.h>

#include "core/wire/endpoints.h"
#include "tests/core/wire/types/foreign_talk.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"

namespace galilean::monitor {
namespace {

using wire::Cdr;
using wire::Delivery;
using wire::Foreign;
using wire::ForeignTalk;
using wire::wait_until;

class TopicRecordingTest : public testing::Test {
 protected:
  ForeignTalk talk(Delivery delivery) const {
    return {process.participant(), Foreign::kCells, kTopic, Cdr::kFirst, "", delivery};
  }
  /// Follows all writers of the topic, once there are so many.
  void follow(std::size_t count) {
    std::vector<wire::EndpointInfo> writers;
    ASSERT_TRUE(wait_until([&] {
      writers = endpoints.known();
      std::erase_if(writers, [](const auto& end) { return !end.writes || end.topic != kTopic; });
      return writers.size() == count;
    }));
    if (!recording) record(writers.front());
    for (const auto& writer : writers) recording->follow(writer);
  }
  void record(const wire::EndpointInfo& writer) {
    recording.emplace(
        TopicRecording::Setup{.participant = *own,
                              .kind = TopicRecording::kind_of(writer),
                              .depth = 100,
                              .find = [this](std::uint64_t handle) { return find(handle); },
                              .on_data = [] {}});
  }
  std::optional<wire::EndpointInfo> find(std::uint64_t handle) {
    for (const auto& end : endpoints.known())
      if (end.handle == handle) return end;
    return std::nullopt;
  }
  /// Returns how many messages come, of which so many are expected, and a while afterwards.
  std::size_t comes(std::size_t expected) {
    std::size_t count = 0;
    const auto take = [&] { recording->take([&](const auto&, const auto&) { ++count; }); };
    EXPECT_TRUE(wait_until([&] { return take(), count >= expected; }));
    for (int i = 0; i < 50; ++i) static_cast<void>(wait_until([&] { return take(), true; }));
    return count;
  }
  std::uint64_t lost() const {
    std::uint64_t sum = 0;
    for (const auto& [guid, writer] : recording->writers()) sum += writer.tally.lost();
    return sum;
  }

  static constexpr const char* kTopic = "rt/cells";
  const int domain = free_domain();
  std::unique_ptr<wire::Participant> own = wire::Participant::join("reader", domain).value();
  wire::Endpoints endpoints{*own};
  wire::ForeignProcess process{"talker", domain};
  std::optional<TopicRecording> recording;
};

TEST_F(TopicRecordingTest, WhatWasKeptForLateJoinersComes) {
  auto state = talk(Delivery::kState);
  ASSERT_TRUE(state.write());
  follow(1);
  EXPECT_EQ(comes(1), 1U);
}

TEST_F(TopicRecordingTest, WritersOfEveryQualityAreHeardEachOnce) {
  auto state = talk(Delivery::kState);
  auto flow = talk(Delivery::kFlow);
  auto stream = talk(Delivery::kStream);
  follow(3);
  // The readers that ask for less match the better writers, too.
  ASSERT_TRUE(wait_until(
      [&] { return state.readers() == 3 && flow.readers() == 2 && stream.readers() == 1; }));
  for (auto* writer : {&state, &flow, &stream}) ASSERT_TRUE(writer->write());
  EXPECT_EQ(comes(3), 3U);
  EXPECT_EQ(lost(), 0U);
}

TEST_F(TopicRecordingTest, AWriterThatComesLaterAndOffersLessIsHeardToo) {
  auto state = talk(Delivery::kState);
  ASSERT_TRUE(state.write());
  follow(1);
  EXPECT_EQ(comes(1), 1U);
  auto stream = talk(Delivery::kStream);
  follow(2);
  ASSERT_TRUE(wait_until([&] { return stream.readers() == 1; }));
  ASSERT_TRUE(stream.write());
  EXPECT_EQ(comes(1), 1U);
}

TEST_F(TopicRecordingTest, AWriterThatWasNotFollowedYetIsHeardUnderItsName) {
  auto first = talk(Delivery::kState);
  follow(1);
  ASSERT_TRUE(wait_until([&] { return first.readers() == 1; }));
  auto second = talk(Delivery::kState);
  ASSERT_TRUE(wait_until([&] { return second.readers() == 1; }));
  ASSERT_TRUE(second.write());
  EXPECT_EQ(comes(1), 1U);
  for (const auto& [guid, writer] : recording->writers())
    EXPECT_EQ(writer.info.process, "talker") << guid;
  follow(2);
  ASSERT_TRUE(second.write());
  EXPECT_EQ(comes(1), 1U);
  EXPECT_EQ(recording->writers().size(), 2U);
}

TEST_F(TopicRecordingTest, HearsAWriterOnceDdsHasConnectedIt) {
  auto state = talk(Delivery::kState);
  follow(1);
  const auto writer = recording->writers().begin()->second.info;
  EXPECT_TRUE(wait_until([&] { return recording->hears(writer); }));
}

TEST_F(TopicRecordingTest, CountsWhatCameBeforeItsTurn) {
  auto state = talk(Delivery::kState);  // keeps one
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(state.write());
  follow(1);
  EXPECT_EQ(comes(1), 1U);
  EXPECT_EQ(recording->writers().begin()->second.tally.sent_before(), 2U);
  EXPECT_EQ(lost(), 0U);
}

TEST_F(TopicRecordingTest, CountsWhatItsOwnQueueDropped) {
  auto state = talk(Delivery::kState);
  follow(1);
  ASSERT_TRUE(wait_until([&] { return state.readers() == 1; }));
  ASSERT_TRUE(state.write());
  EXPECT_EQ(comes(1), 1U);
  for (int i = 0; i < 250; ++i) ASSERT_TRUE(state.write());
  ASSERT_TRUE(state.arrived());
  EXPECT_TRUE(wait_until([&] { return comes(0) + lost() >= 150U; }));
  EXPECT_GT(lost(), 0U);
  EXPECT_EQ(recording->writers().begin()->second.overrun, lost());
}

}  // namespace
}  // namespace galilean::monitor
