// SPDX-License-Identifier: BSD-3-Clause
// How a recorder keeps what came shortly before and after an event, and nothing else.
#include <gmock/gmock.h>

#include <utility>

#include "monitor/record/recorder.h"
#include "tests/monitor/record/recorder_fixture.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;
using wire::Delivery;
using wire::Foreign;

/// Something that happens when the test says so.
class SaidSo final : public Trigger {
 public:
  bool wants(const wire::EndpointInfo& writer) const override { return writer.topic == needed; }
  void take(const wire::EndpointInfo&, const wire::Received&, Time) override { ++taken; }
  std::optional<std::string> happened() override { return std::exchange(event, std::nullopt); }
  std::vector<std::string> doubts() override { return doubted; }

  std::string needed;  ///< a topic
  std::vector<std::string> doubted;
  int taken = 0;
  std::optional<std::string> event;
};

class RecorderSnapshotTest : public RecorderTest {
 protected:
  void start_waiting(Selection selection = {}) {
    snapshots = {
        .trigger = &trigger, .before = std::chrono::seconds(3), .after = std::chrono::seconds(2)};
    start(std::move(selection));
  }
  /// Sends a message and waits until the recorder has it.
  void receive(wire::ForeignTalk& writer) {
    const int before = trigger.taken;
    ASSERT_TRUE(writer.write());
    ASSERT_TRUE(wire::wait_until([&] { return pump(), trigger.taken > before; }));
  }

  SaidSo trigger;
};

TEST_F(RecorderSnapshotTest, WritesWhatCameShortlyBeforeAndAfter) {
  auto state = talk(Foreign::kCells, "rt/state");
  auto flow = talk(Foreign::kCells, "rt/flow", Delivery::kFlow);
  start_waiting();
  ASSERT_TRUE(comes_to_be_heard(state));
  ASSERT_TRUE(comes_to_be_heard(flow));
  receive(state);
  for (int i = 0; i < 6; ++i) {  // one a second, of which those of the last three seconds are kept
    look();
    receive(flow);
  }
  EXPECT_FALSE(files->is_open());
  EXPECT_EQ(total_missing(recorder->recordings().losses()), 0U);

  trigger.event = "io: state is 'stuck'";
  pump();
  ASSERT_TRUE(files->is_open());
  EXPECT_THAT(warnings, HasSubstr("io: state is 'stuck': recorded to "));
  receive(flow);
  look();
  EXPECT_TRUE(files->is_open());
  look();
  EXPECT_FALSE(files->is_open());
  receive(flow);

  const auto summary = summary_of("run.mcap");
  EXPECT_FALSE(summary.recovered());
  std::map<std::string, std::uint64_t> counts;
  for (const auto& [id, channel] : summary.channels)
    counts[channel.topic] = summary.statistics.channel_messages.at(id);
  EXPECT_EQ(counts["/state"], 1U);  // though it came long before
  EXPECT_EQ(counts["/flow"], 5U);
  EXPECT_EQ(summary.metadata.front().entries.at("event"), "io: state is 'stuck'");
}

TEST_F(RecorderSnapshotTest, EachEventHasAFileAndALaterOneMakesItLonger) {
  auto flow = talk(Foreign::kCells, "rt/flow", Delivery::kFlow);
  start_waiting();
  ASSERT_TRUE(comes_to_be_heard(flow));
  receive(flow);
  trigger.event = "one";
  pump();
  look();
  trigger.event = "two";
  pump();
  look();
  EXPECT_TRUE(files->is_open());
  look();
  EXPECT_FALSE(files->is_open());
  receive(flow);
  trigger.event = "three";
  pump();
  ASSERT_TRUE(recorder->conclude());
  EXPECT_EQ(files->totals().files, 2U);
  EXPECT_EQ(summary_of("run_1.mcap").metadata.front().entries.at("event"), "three");
  EXPECT_EQ(summary_of("run_1.mcap").statistics.messages, 1U);
}

TEST_F(RecorderSnapshotTest, WithoutAnEventThereIsNoFile) {
  auto flow = talk(Foreign::kCells, "rt/flow", Delivery::kFlow);
  start_waiting();
  ASSERT_TRUE(comes_to_be_heard(flow));
  receive(flow);
  look();
  ASSERT_TRUE(recorder->conclude());
  EXPECT_EQ(files->totals().files, 0U);
  EXPECT_FALSE(std::filesystem::exists(folder / "run.mcap"));
}

TEST_F(RecorderSnapshotTest, WhatTheEventNeedsIsHeardThoughItIsNotRecorded) {
  auto state = talk(Foreign::kCells, "rt/state");
  auto flow = talk(Foreign::kCells, "rt/flow", Delivery::kFlow);
  trigger.needed = "rt/flow";
  Selection selection;
  selection.topics.emplace_back("state");
  start_waiting(std::move(selection));
  ASSERT_TRUE(comes_to_be_heard(state));
  ASSERT_TRUE(comes_to_be_heard(flow));
  receive(state);
  receive(flow);
  trigger.event = "flow";
  pump();
  receive(flow);
  EXPECT_EQ(recorder->recordings().topics(), 1U);
  EXPECT_EQ(recorder->recordings().losses().size(), 1U);
  const auto summary = recorded();
  ASSERT_EQ(summary.channels.size(), 1U);
  EXPECT_EQ(summary.channels.begin()->second.topic, "/state");
}

TEST_F(RecorderSnapshotTest, SaysOnceWhyTheEventCannotHappen) {
  start_waiting();
  pump();
  trigger.doubted = {"io's program has no state 'stuk'"};
  look();
  look();
  EXPECT_EQ(warnings, "io's program has no state 'stuk'\n");
}

}  // namespace
}  // namespace galilean::monitor
