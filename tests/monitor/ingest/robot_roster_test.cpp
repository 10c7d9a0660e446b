// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/ingest/robot_roster.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

class RobotRosterTest : public testing::Test {
 protected:
  /// Fills all places, one robot a second: invented_0 is the oldest.
  void fill() {
    for (std::size_t i = 0; i < RobotRoster::kMost; ++i) {
      EXPECT_TRUE(hear("invented_" + std::to_string(i)).is_followed);
      clock.advance(1s);
    }
  }
  [[nodiscard]] RobotRoster::Admission hear(const std::string& robot) {
    return roster.hear(robot, clock.now());
  }

  SteppedClock clock;
  RobotRoster roster;
};

TEST_F(RobotRosterTest, NobodyIsForgottenWhileThereIsRoom) {
  EXPECT_TRUE(hear("io").is_followed);
  clock.advance(48h);
  const auto europa = hear("europa");
  EXPECT_TRUE(europa.is_followed);
  EXPECT_EQ(europa.forgotten, "");
  EXPECT_EQ(roster.size(), 2U);
  EXPECT_EQ(roster.forgotten(), 0U);
}

TEST_F(RobotRosterTest, ARobotThatWasSilentForAnHourGivesItsPlaceToOneThatNeedsIt) {
  fill();
  EXPECT_FALSE(hear("europa").is_followed) << "all places are taken";
  clock.advance(RobotRoster::kForgetAfter - 257s);
  EXPECT_FALSE(hear("europa").is_followed) << "the oldest was silent for an hour less a second";
  clock.advance(1s);
  const auto europa = hear("europa");
  EXPECT_TRUE(europa.is_followed);
  EXPECT_EQ(europa.forgotten, "invented_0");
  EXPECT_FALSE(hear("themisto").is_followed) << "the next oldest is a second younger";
  EXPECT_EQ(roster.size(), RobotRoster::kMost);
  EXPECT_EQ(roster.forgotten(), 1U);
}

TEST_F(RobotRosterTest, ARobotThatIsHeardKeepsItsPlaceHoweverOldItIs) {
  fill();
  clock.advance(2h);
  EXPECT_TRUE(hear("invented_0").is_followed);
  EXPECT_EQ(hear("europa").forgotten, "invented_1");
  clock.advance(2h);
  EXPECT_TRUE(hear("invented_0").is_followed);
}

TEST_F(RobotRosterTest, OneThatWasForgottenComesBackLikeANewOne) {
  fill();
  clock.advance(2h);
  EXPECT_EQ(hear("europa").forgotten, "invented_0");
  const auto back = hear("invented_0");
  EXPECT_TRUE(back.is_followed);
  EXPECT_EQ(back.forgotten, "invented_1");
}

TEST_F(RobotRosterTest, NamesThatAreInventedForDaysTakeNoMoreThanThePlaces) {
  for (int i = 0; i < 20'000; ++i) {
    (void)hear("invented_" + std::to_string(i));
    clock.advance(10s);
    EXPECT_LE(roster.size(), RobotRoster::kMost);
  }
  EXPECT_GT(roster.forgotten(), 0U);
}

}  // namespace
}  // namespace galilean::monitor
