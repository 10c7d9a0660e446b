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

}  // namespace
}  // namespace galilean::monitor
