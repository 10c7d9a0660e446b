// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/ingest/ingest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <limits>
#include <set>

#include "core/wire/messages.h"
#include "core/wire/refusals.h"
#include "core/wire/topic_names.h"
#include "core/wire/writer.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"

namespace galilean::monitor {
namespace {

msg::RobotState state_of(const std::string& robot) {
  msg::RobotState state;
  state.robot = robot;
  return state;
}

class IngestTest : public testing::Test {
 protected:
  /// Polls until the condition holds. Returns whether it came to that.
  template <class Condition>
  bool comes(Condition condition) {
    return wire::wait_until([&] {
      ingest.poll();
      return condition();
    });
  }
  [[nodiscard]] std::uint64_t refused() const {
    std::uint64_t all = 0;
    for (const auto& each : ingest.intake().refused) all += each.messages;
    return all;
  }

  const int domain = free_domain();
  std::unique_ptr<wire::Participant> robots = wire::Participant::join("robots", domain).value();
  std::unique_ptr<wire::Participant> monitor =
      wire::Participant::join(wire::kMonitorName, domain).value();
  std::size_t messages = 0;
  std::set<std::string> topics;
  std::vector<std::string> problems;
  std::atomic<int> wakes = 0;
  Ingest ingest{*monitor,
                {.channel = [this](const Channel& channel) { topics.insert(channel.topic); },
                 .message = [this](const Message&) { ++messages; },
                 .problem = [this](const std::string& problem) { problems.push_back(problem); }},
                [this] { ++wakes; }};
};

TEST_F(IngestTest, TellsHowOldTheNewestMessageOfAChannelIs) {
  wire::Writer<msg::RobotState> states(*robots, wire::robot_topic("io", "state"));
  ASSERT_TRUE(comes([&] { return topics.contains("rt/io/state"); }));
  ASSERT_TRUE(states.write(state_of("io")));
  ASSERT_TRUE(comes([&] { return messages == 1; }));
  const auto channels = ingest.intake().channels;
  const auto io = std::ranges::find(channels, "rt/io/state", &ChannelIntake::topic);
  ASSERT_NE(io, channels.end());
  EXPECT_EQ(io->messages, 1U);
  ASSERT_TRUE(io->age_s);
  EXPECT_GE(*io->age_s, 0);
}

TEST_F(IngestTest, AMessageOutsideOfItsBoundsReachesNobodyAndTakesNoPlace) {
  wire::Writer<msg::RobotState> states(*robots, wire::robot_topic("io", "state"));
  auto broken = state_of("io");
  broken.heading_rad = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(states.write(broken));
  ASSERT_TRUE(comes([&] { return refused() == 1; }));
  EXPECT_EQ(messages, 0U);
  ASSERT_TRUE(states.write(state_of("io")));
  ASSERT_TRUE(comes([&] { return messages == 1; }));
}

TEST_F(IngestTest, FollowsOnlySoManyRobotsAndNamesTheFirstBeyond) {
  wire::Writer<msg::RobotState> states(*robots, wire::robot_topic("stranger", "state"));
  for (std::size_t i = 0; i < Ingest::kMostRobots; ++i) {
    ASSERT_TRUE(states.write(state_of("invented_" + std::to_string(i))));
    ASSERT_TRUE(comes([&] { return messages == i + 1; }));
  }
  for (std::uint64_t i = 1; i <= 3; ++i) {
    ASSERT_TRUE(states.write(state_of("europa_" + std::to_string(i))));
    ASSERT_TRUE(comes([&] { return refused() == i; }));
  }
  EXPECT_EQ(messages, Ingest::kMostRobots);
  const auto kinds = ingest.intake().refused;
  ASSERT_EQ(kinds.size(), 1U);
  EXPECT_EQ(kinds[0].topic, wire::Refusals::kOthers);
  EXPECT_EQ(kinds[0].reason, "more than 256 robots are not followed, such as europa_1");
  ASSERT_TRUE(states.write(state_of("invented_7")));
  ASSERT_TRUE(comes([&] { return messages == Ingest::kMostRobots + 1; }));
}

TEST_F(IngestTest, AFloodOfMessagesIsTakenInInPortionsAndNothingIsLost) {
  constexpr std::uint64_t kCommands = 5 * Ingest::kMostAtOnce;
  wire::Writer<msg::Command> commands(*robots, wire::kCommandTopic);
  wire::Writer<msg::RobotState> states(*robots, wire::robot_topic("io", "state"));
  ASSERT_TRUE(comes([&] { return topics.size() == 2; }));
  ASSERT_TRUE(wire::wait_until([&] { return commands.readers() == 1 && states.readers() == 1; }));
  for (std::uint64_t i = 0; i < kCommands; ++i) ASSERT_TRUE(commands.write(msg::Command{}));
  ASSERT_TRUE(states.write(state_of("io")));
  const auto most_a_turn = 2 * Ingest::kMostAtOnce;  // of the two topics
  ASSERT_TRUE(wire::wait_until([&] {
    const std::size_t before = messages;
    ingest.poll();
    EXPECT_LE(messages - before, most_a_turn);
    return messages == kCommands + 1;
  }));
}

TEST_F(IngestTest, WakesItsThreadForWhatATurnLeft) {
  wire::Writer<msg::Command> commands(*robots, wire::kCommandTopic);
  ASSERT_TRUE(comes([&] { return topics.size() == 1; }));
  ASSERT_TRUE(wire::wait_until([&] { return commands.readers() == 1; }));
  for (std::size_t i = 0; i < 2 * Ingest::kMostAtOnce; ++i)
    ASSERT_TRUE(commands.write(msg::Command{}));
  // From now on it is asked only when it has said that something waits.
  ASSERT_TRUE(wire::wait_until([&] {
    while (wakes.exchange(0) > 0) ingest.poll();
    return messages == 2 * Ingest::kMostAtOnce;
  }));
}

TEST_F(IngestTest, AFloodOfTopicsIsTakenInInPortions) {
  constexpr std::size_t kTopics = 3 * Ingest::kMostNewTopics;
  std::deque<wire::Writer<msg::Breaks>> writers;
  for (std::size_t i = 0; i < kTopics; ++i)
    writers.emplace_back(*robots, wire::robot_topic("invented_" + std::to_string(i), "breaks"));
  ASSERT_TRUE(wire::wait_until([&] {
    const std::size_t before = topics.size();
    ingest.poll();
    EXPECT_LE(topics.size() - before, Ingest::kMostNewTopics);
    return topics.size() == kTopics;
  }));
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(ingest.intake().topics_not_read, 0U);
}

}  // namespace
}  // namespace galilean::monitor
