// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/gains/reach.h"

#include <gtest/gtest.h>

namespace galilean::monitor::top {
namespace {

using Names = std::vector<std::string>;

class ReachTest : public testing::Test {
 protected:
  void hear(const std::string& name, const std::string& hash, bool out_of_service = false) {
    msg::RobotState state;
    state.robot = name;
    state.program_hash = hash;
    state.out_of_service = out_of_service;
    team.note(state);
    msg::Program program;
    program.robot = name;
    program.hash = hash;
    team.note(program);
    msg::Catalog catalog;
    catalog.robot = name;
    team.note(catalog);
  }

  SteppedClock clock;
  Team team{clock};
};

TEST_F(ReachTest, TheWholeTeamIsNamedByNobodysName) {
  hear("callisto", "1111");
  hear("io", "1111");
  const Reach reach = reach_of(team, "");
  EXPECT_EQ(reach.robots, (Names{"callisto", "io"}));
  EXPECT_EQ(reach.targets, Names{});
  ASSERT_NE(reach.program, nullptr);
  EXPECT_EQ(reach.program->hash, "1111");
  EXPECT_NE(reach.catalog, nullptr);
}

TEST_F(ReachTest, WhoIsPlayedFromARecordingIsLeftOut) {
  hear("callisto", "2222");
  team.note_replay("callisto");
  hear("io", "1111");
  EXPECT_EQ(reach_of(team, "").robots, Names{"io"});
}

TEST_F(ReachTest, WhoIsSilentOrOutOfServiceIsLeftOut) {
  hear("callisto", "2222");
  clock.advance(std::chrono::seconds(3));
  hear("ganymede", "2222", true);
  hear("io", "1111");
  const Reach reach = reach_of(team, "");
  EXPECT_EQ(reach.robots, Names{"io"});
  EXPECT_EQ(reach.targets, Names{"io"});
  ASSERT_NE(reach.program, nullptr);
  EXPECT_EQ(reach.program->hash, "1111");
}

TEST_F(ReachTest, RobotsThatRunDifferentProgramsHaveNoneInCommon) {
  hear("callisto", "2222");
  hear("io", "1111");
  EXPECT_EQ(reach_of(team, "").program, nullptr);
  const Reach reach = reach_of(team, "io");
  EXPECT_EQ(reach.targets, Names{"io"});
  ASSERT_NE(reach.program, nullptr);
}

TEST_F(ReachTest, AProgramThatIsNotYetToldIsNotKnown) {
  hear("io", "1111");
  msg::RobotState state;
  state.robot = "io";
  state.program_hash = "2222";
  team.note(state);
  EXPECT_EQ(reach_of(team, "io").program, nullptr);
  EXPECT_TRUE(reach_of(team, "europa").robots.empty());
}

}  // namespace
}  // namespace galilean::monitor::top
