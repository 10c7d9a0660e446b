// SPDX-License-Identifier: BSD-3-Clause
// What a recorder does while it is paused, and what its file tells of it.
#include <gmock/gmock.h>

#include <algorithm>

#include "core/wire/messages.h"
#include "core/wire/writer.h"
#include "monitor/record/recorder.h"
#include "monitor/record/told_losses.h"
#include "monitor/record/told_pauses.h"
#include "tests/monitor/record/recorder_fixture.h"

namespace galilean::monitor {
namespace {

using wire::Delivery;
using wire::Foreign;

class RecorderPauseTest : public RecorderTest {
 protected:
  void pause() {
    ASSERT_TRUE(recorder->pause("anna"));
    ASSERT_TRUE(recorder->paused().has_value());
  }
  Pause resume() {
    auto ended = recorder->resume();
    EXPECT_TRUE(ended && ended.value());
    return ended.value().value();
  }
  [[nodiscard]] bool come_in_the_pause(std::uint64_t messages) {
    return wire::wait_until([&] { return pump(), recorder->paused()->messages >= messages; });
  }
  [[nodiscard]] std::vector<Pause> told(const std::string& name) const {
    const auto source = mcap::FileSource::open(folder / name);
    return told_pauses(source.value(), summary_of(name));
  }
  [[nodiscard]] static std::uint64_t messages_of(const mcap::Summary& summary,
                                                 const std::string& topic) {
    std::uint64_t count = 0;
    for (const auto& [id, messages] : summary.statistics.channel_messages)
      if (summary.channels.at(id).topic == topic) count += messages;
    return count;
  }
};

TEST_F(RecorderPauseTest, NothingThatCameInAPauseIsRecordedOrCalledLost) {
  auto flow = talk(Foreign::kCells, "rt/flow", Delivery::kFlow);
  start();
  ASSERT_TRUE(comes_to_be_heard(flow));
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(flow.write());
  ASSERT_TRUE(comes_to_record(3));
  pause();
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(flow.write());
  ASSERT_TRUE(come_in_the_pause(4));
  const auto ended = resume();
  EXPECT_EQ(ended.messages, 4U);
  EXPECT_EQ(ended.by, "anna");
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(flow.write());
  ASSERT_TRUE(comes_to_record(3 + 2 + 2));  // with what is told of the pause
  const auto losses = recorder->recordings().losses();
  ASSERT_EQ(losses.size(), 1U);
  EXPECT_EQ(losses[0].recorded, 5U);
  EXPECT_EQ(losses[0].paused, 4U);
  EXPECT_EQ(losses[0].missing(), 0U);
  const auto summary = recorded();
  EXPECT_EQ(messages_of(summary, "/flow"), 5U);
  EXPECT_EQ(told("run.mcap"), std::vector{ended});
}

TEST_F(RecorderPauseTest, NumbersSkipInNoChannel) {
  auto flow = talk(Foreign::kCells, "rt/flow", Delivery::kFlow);
  start();
  ASSERT_TRUE(comes_to_be_heard(flow));
  ASSERT_TRUE(flow.write());
  ASSERT_TRUE(comes_to_record(1));
  pause();
  ASSERT_TRUE(flow.write());
  ASSERT_TRUE(come_in_the_pause(1));
  resume();
  ASSERT_TRUE(flow.write());
  ASSERT_TRUE(comes_to_record(1 + 1 + 2));
  std::vector<std::string> parts;
  for (const auto& [id, channel] : recorded().channels)
    if (channel.topic == "/flow")
      parts.push_back(channel.metadata.contains(kChannelPart) ? channel.metadata.at(kChannelPart)
                                                              : "");
  EXPECT_THAT(parts, testing::UnorderedElementsAre("", "2"));
}

TEST_F(RecorderPauseTest, GoesOnWithTheStatesThatHaveChangedMeanwhile) {
  auto changing = talk(Foreign::kCells, "rt/changing");
  auto still = talk(Foreign::kCells, "rt/still");
  ASSERT_TRUE(changing.write());
  ASSERT_TRUE(still.write());
  start();
  ASSERT_TRUE(comes_to_record(2));
  pause();
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(changing.write());
  ASSERT_TRUE(come_in_the_pause(3));
  resume();
  const auto summary = recorded();
  EXPECT_EQ(messages_of(summary, "/changing"), 2U);
  EXPECT_EQ(messages_of(summary, "/still"), 1U);
}

TEST_F(RecorderPauseTest, APauseThatDoesNotEndLastsUntilTheFileDoes) {
  start();
  pump();
  pause();
  ASSERT_TRUE(recorder->pause("bert"));  // changes nothing
  (void)recorded();
  const auto pauses = told("run.mcap");
  ASSERT_EQ(pauses.size(), 1U);
  EXPECT_TRUE(pauses[0].to_ns.has_value());
  EXPECT_EQ(pauses[0].by, "anna");
}

TEST_F(RecorderPauseTest, NoFileIsBegunInAPause) {
  FilePlan plan;
  plan.split_span = kLookEach;
  start({}, plan);
  pump();
  pause();
  for (int i = 0; i < 3; ++i) look();
  EXPECT_EQ(files->totals().files, 1U);
  resume();
  look();
  EXPECT_EQ(files->totals().files, 2U);
}

TEST_F(RecorderPauseTest, ResumingWhatIsNotPausedChangesNothing) {
  start();
  const auto ended = recorder->resume();
  ASSERT_TRUE(ended.ok());
  EXPECT_FALSE(ended.value().has_value());
  EXPECT_TRUE(recorded().channels.empty());
}

TEST_F(RecorderPauseTest, EachChangeOfAProgramIsToldWithItsHash) {
  const auto robot = wire::Participant::join("io", domain).value();
  wire::Writer<msg::Program> programs(*robot, "rt/io/program");
  const auto run = [&](const std::string& hash) {
    msg::Program program;
    program.robot = "io";
    program.name = "office.bhdl";
    program.hash = hash;
    ASSERT_TRUE(programs.write(program));
  };
  start();
  std::uint64_t messages = 0;
  for (const char* hash : {"aa", "aa", "bb"}) {
    run(hash);
    ASSERT_TRUE(comes_to_record(++messages));
  }
  std::vector<std::string> hashes;
  for (const auto& metadata : recorded().metadata)
    if (metadata.name == kProgramMetadata) hashes.push_back(metadata.entries.at("hash"));
  EXPECT_THAT(hashes, testing::ElementsAre("aa", "bb"));
}

}  // namespace
}  // namespace galilean::monitor
