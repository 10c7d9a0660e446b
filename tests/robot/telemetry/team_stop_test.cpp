// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/team_stop.h"

#include <gtest/gtest.h>

namespace galilean::robot {
namespace {

TEST(TeamStop, GoesOutAsAHoldForAllAndIsReadAgain) {
  const auto command = command_of({"io", "break point wander -> grab", "Anna"}, 17);
  EXPECT_EQ(command.kind, msg::Command_Constants::HOLD);
  EXPECT_TRUE(command.targets.empty());
  EXPECT_EQ(command.id, "break:io:17");
  EXPECT_EQ(command.author, "io: break point wander -> grab, set by Anna");
  const auto stop = team_stop_in(command);
  ASSERT_TRUE(stop);
  EXPECT_EQ(stop->robot, "io");
  EXPECT_EQ(stop->break_point, "break point wander -> grab");
  EXPECT_EQ(stop->author, "Anna");
}

TEST(TeamStop, OtherCommandsAreNone) {
  msg::Command command;
  command.id = "1234-5678";
  command.kind = msg::Command_Constants::HOLD;
  EXPECT_FALSE(team_stop_in(command));
  command.id = "break:io:17";
  command.kind = msg::Command_Constants::RESUME;
  EXPECT_FALSE(team_stop_in(command));
}

TEST(TeamStop, AnotherProgramsWordsAreTakenAsTheyAre) {
  msg::Command command;
  command.id = "break:";
  command.author = "the referee";
  command.kind = msg::Command_Constants::HOLD;
  const auto stop = team_stop_in(command);
  ASSERT_TRUE(stop);
  EXPECT_EQ(stop->robot, "");
  EXPECT_EQ(stop->break_point, "the referee");
  EXPECT_EQ(stop->author, "");
}

}  // namespace
}  // namespace galilean::robot
