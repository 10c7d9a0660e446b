// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/refusal_watch.h"

#include <gtest/gtest.h>

#include "monitor/top/model/alarms.h"

namespace galilean::monitor::top {
namespace {

using namespace std::chrono_literals;

Intake refusing(std::uint64_t messages, const std::string& topic = "rt/io/state") {
  Intake intake;
  intake.refused = {{topic, "RobotState.heading_rad is not a number", messages}};
  return intake;
}

TEST(RefusalWatch, SaysWhichMessagesWereNotTakenWhyAndHowMany) {
  RefusalWatch watch;
  watch.look(refusing(12), Time{1s});
  watch.look(refusing(1, wire::Refusals::kOthers), Time{1s});
  const auto ongoing = watch.ongoing(Time{2s});
  ASSERT_EQ(ongoing.size(), 2U);
  EXPECT_EQ(ongoing[0].sender, "(others)");
  EXPECT_EQ(ongoing[0].words, "1 message was not taken: RobotState.heading_rad is not a number");
  EXPECT_EQ(ongoing[1].sender, "io");
  EXPECT_EQ(ongoing[1].words,
            "12 messages on /io/state were not taken: RobotState.heading_rad is not a number");
}

TEST(RefusalWatch, IsOverWhenNoMoreComeAndBeginsAgainWhenTheyDo) {
  RefusalWatch watch;
  for (auto at = 1s; at < 31s; ++at) watch.look(refusing(3), Time{at});
  EXPECT_EQ(watch.ongoing(Time{30s}).size(), 1U);
  EXPECT_TRUE(watch.ongoing(Time{31s}).empty());
  watch.look(refusing(4), Time{40s});
  EXPECT_EQ(watch.ongoing(Time{41s}).size(), 1U);
}

TEST(RefusalWatch, TellsOfTopicsThatAreNotRead) {
  RefusalWatch watch;
  Intake intake;
  watch.look(intake, Time{1s});
  EXPECT_TRUE(watch.ongoing(Time{1s}).empty());
  intake.topics_not_read = 3;
  watch.look(intake, Time{2s});
  ASSERT_EQ(watch.ongoing(Time{2s}).size(), 1U);
  EXPECT_EQ(watch.ongoing(Time{2s})[0].words, "3 topics are not read, because there are too many");
}

TEST(RefusalWatch, TellsOfEventsThatWereLost) {
  RefusalWatch watch;
  Intake intake;
  ChannelIntake& channel = intake.channels.emplace_back();
  channel.topic = "rt/io/transition";
  channel.filled = 1024;
  watch.look(intake, Time{1s});
  EXPECT_TRUE(watch.ongoing(Time{1s}).empty());
  channel.lost = 12;
  watch.look(intake, Time{2s});
  ASSERT_EQ(watch.ongoing(Time{2s}).size(), 1U);
  EXPECT_EQ(watch.ongoing(Time{2s})[0].sender, "io");
  EXPECT_EQ(watch.ongoing(Time{2s})[0].words,
            "12 messages on /io/transition were lost: more happened in a gap than the robot keeps");
  EXPECT_TRUE(watch.ongoing(Time{2s})[0].is_loss);
}

TEST(RefusalWatch, IsAnAlarmOfTheDashboard) {
  SteppedClock clock;
  DashboardModel model(clock);
  model.note(refusing(12));
  AlarmFinder finder;
  const auto alarms = finder.find(model, clock.now());
  ASSERT_EQ(alarms.size(), 1U);
  EXPECT_EQ(alarms[0].kind, AlarmKind::kRefused);
  EXPECT_EQ(alarms[0].robot, "io");
  clock.advance(RefusalWatch::kGoesOn);
  EXPECT_TRUE(finder.find(model, clock.now()).empty());
}

}  // namespace
}  // namespace galilean::monitor::top
