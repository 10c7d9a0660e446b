// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/choice.h"

#include <gmock/gmock.h>

namespace galilean::monitor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Tracks of_a_robot() {
  Tracks tracks;
  tracks.played[1] = {.topic = "rt/io/state"};
  tracks.played[2] = {.topic = "rt/io/program"};
  tracks.played[3] = {.topic = "rt/io/state"};
  return tracks;
}

std::vector<std::string> played(const Tracks& tracks) {
  std::vector<std::string> topics;
  for (const auto& [id, track] : tracks.played) topics.push_back(track.topic);
  return topics;
}

TEST(ReplayChoice, LeavesTheTopicsThatAreWanted) {
  for (const char* topic : {"/io/state", "io/state"}) {
    auto tracks = of_a_robot();
    ASSERT_TRUE(choose({.topics = {topic}}, tracks));
    EXPECT_THAT(played(tracks), ElementsAre("rt/io/state", "rt/io/state"));
  }
  auto all = of_a_robot();
  ASSERT_TRUE(choose({}, all));
  EXPECT_EQ(all.played.size(), 3U);
}

TEST(ReplayChoice, PlaysTopicsUnderOtherNames) {
  auto tracks = of_a_robot();
  ASSERT_TRUE(choose({.renamed = {read_renamed("io/state:=/europa/state").value(),
                                  read_renamed("/io/program:=io/state").value()}},
                     tracks));
  EXPECT_THAT(played(tracks), ElementsAre("rt/europa/state", "rt/io/state", "rt/europa/state"));
}

TEST(ReplayChoice, SaysWhatMayHaveBeenMeant) {
  auto tracks = of_a_robot();
  const auto refused = choose({.topics = {"/io/stat"}}, tracks);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("did you mean '/io/state'?"));
  EXPECT_FALSE(choose({.renamed = {{"/x", "/y"}}}, tracks));
}

TEST(ReplayChoice, RefusesWhatIsNoNameOfATopic) {
  for (const char* text : {"", "/io/state", ":=", "/a:=", "/a:=/", "/a:=/b/", "/a:=//b", "/a:=/b c",
                           "/a:=/1b", "/a:=/b\x1b[31m"})
    EXPECT_FALSE(read_renamed(text)) << text;
}

Tracks of_a_team() {
  constexpr const char* kStateType = "galilean_msgs/msg/RobotState";
  Tracks tracks;
  tracks.played[1] = {.topic = "rt/io/state", .ros_type = kStateType, .sender = "io"};
  tracks.played[2] = {.topic = "rt/io/program", .sender = "io"};
  tracks.played[3] = {.topic = "rt/tf", .sender = "io"};
  tracks.played[4] = {.topic = "rt/callisto/state", .ros_type = kStateType, .sender = "callisto"};
  tracks.played[5] = {.topic = "rt/tf", .sender = "callisto"};
  tracks.played[6] = {.topic = "rt/tf", .sender = "monitor"};
  tracks.played[7] = {.topic = "rt/referee/score", .sender = "sim"};
  tracks.played[8] = {.topic = "rt/team/objects", .sender = "monitor"};
  return tracks;
}

TEST(ReplayChoice, LeavesWhatTheRobotsSentThatAreWanted) {
  auto tracks = of_a_team();
  ASSERT_TRUE(choose({.robots = {"io"}}, tracks));
  EXPECT_THAT(played(tracks), ElementsAre("rt/io/state", "rt/io/program", "rt/tf"));
  EXPECT_EQ(tracks.played.at(3).sender, "io");
  auto both = of_a_team();
  ASSERT_TRUE(choose({.robots = {"io", "callisto"}, .topics = {"/tf", "/io/state"}}, both));
  EXPECT_THAT(played(both), ElementsAre("rt/io/state", "rt/tf", "rt/tf"));
  auto renamed = of_a_team();
  ASSERT_TRUE(choose({.robots = {"io"}, .renamed = {{"/io/state", "/europa/state"}}}, renamed));
  EXPECT_THAT(played(renamed), ElementsAre("rt/europa/state", "rt/io/program", "rt/tf"));
}

TEST(ReplayChoice, RefusesRobotsThatAreNotThereAndWhatLeavesNothing) {
  auto tracks = of_a_team();
  const auto unknown = choose({.robots = {"calisto"}}, tracks);
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, HasSubstr("did you mean 'callisto'?"));
  const auto other = choose({.robots = {"europa"}}, tracks);
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("there are callisto and io"));
  EXPECT_FALSE(choose({.robots = {"referee"}}, tracks));
  const auto nothing = choose({.robots = {"io"}, .topics = {"/callisto/state"}}, tracks);
  ASSERT_FALSE(nothing);
  EXPECT_THAT(nothing.error().message, HasSubstr("no topic of io is left"));
}

}  // namespace
}  // namespace galilean::monitor
