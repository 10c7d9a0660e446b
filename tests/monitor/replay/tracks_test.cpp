// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/tracks.h"

#include <gtest/gtest.h>

#include "core/wire/schemas.h"
#include "core/wire/types/message_definition.h"
#include "core/wire/types/own_types.h"
#include "monitor/replay/report.h"

namespace galilean::monitor {
namespace {

/// A recording with one channel a pair of topic and type, in the order given from channel 1 on.
mcap::Summary recording_with(const std::vector<std::pair<std::string, std::string>>& topics) {
  mcap::Summary summary;
  std::uint16_t id = 0;
  for (const auto& [topic, type] : topics) {
    const auto* known = wire::find_schema_by_ros_type(type);
    ++id;
    summary.schemas[id] = {id, type, "ros2idl", std::string(known ? known->idl : "module x {};")};
    summary.channels[id] = {id, id, topic, "cdr", {}};
  }
  return summary;
}

TEST(Tracks, RobotsAreNeverToldASecondTimeWhatToDo) {
  const auto tracks =
      tracks_of(recording_with({{"/io/state", "galilean_msgs/msg/RobotState"},
                                {"/team/program_push", "galilean_msgs/msg/ProgramPush"},
                                {"/team/program_rollback", "galilean_msgs/msg/ProgramRollback"},
                                {"/team/command", "galilean_msgs/msg/Command"}}));
  ASSERT_EQ(tracks.played.size(), 1u);
  EXPECT_EQ(tracks.played.at(1).topic, "rt/io/state");
  EXPECT_EQ(tracks.commands, (std::vector<std::string>{"/team/command", "/team/program_push",
                                                       "/team/program_rollback"}));
}

TEST(Tracks, WhatTicksReadIsRunAgainAndNotSentAgain) {
  const auto tracks = tracks_of(recording_with({{"/io/inputs", "galilean_msgs/msg/TickInputs"}}));
  EXPECT_TRUE(tracks.played.empty());
  EXPECT_TRUE(tracks.foreign.empty());
  ASSERT_TRUE(tracks.inputs.contains(1));
  EXPECT_EQ(tracks.inputs.at(1).topic, "rt/io/inputs");
}

TEST(Tracks, TypesOfOthersAndOfOtherReleasesAreLeftOut) {
  auto recording = recording_with({{"/scan", "sensor_msgs/msg/LaserScan"},
                                   {"/io/state", "galilean_msgs/msg/RobotState"},
                                   {"/io/variables", "galilean_msgs/msg/Variables"}});
  recording.schemas[2].data += "\nmodule more {};";
  const auto tracks = tracks_of(recording);
  EXPECT_EQ(tracks.foreign, (std::vector<std::string>{"/io/state", "/scan"}));
  EXPECT_TRUE(tracks.played.contains(3));
}

TEST(Tracks, AReleaseThatDiffersInCommentsAndLayoutAloneIsPlayed) {
  auto recording = recording_with({{"/io/state", "galilean_msgs/msg/RobotState"},
                                   {"/referee/score", "galilean_msgs/msg/Score"}});
  recording.schemas[1].data += "\n\n  // as it was once";
  const auto comment = recording.schemas[2].data.find("//");
  ASSERT_NE(comment, std::string::npos);
  recording.schemas[2].data.insert(comment + 2, " in other words:\n//");
  EXPECT_EQ(tracks_of(recording).played.size(), 2u);
}

/// As galilean record defines it, in the language of .msg files.
mcap::Schema defined_as_message(const mcap::Schema& schema) {
  const auto* known = wire::find_schema_by_ros_type(schema.name);
  const auto* own = wire::find_own_type(known->dds_type);
  return {schema.id, schema.name, "ros2msg", wire::message_definition(own->description).value()};
}

TEST(Tracks, DefinitionsInTheLanguageOfMessageFilesAreKnownToo) {
  auto recording = recording_with({{"/io/state", "galilean_msgs/msg/RobotState"},
                                   {"/io/variables", "galilean_msgs/msg/Variables"}});
  for (auto& [id, schema] : recording.schemas) schema = defined_as_message(schema);
  recording.schemas[2].data += "int8 more\n";
  const auto tracks = tracks_of(recording);
  EXPECT_TRUE(tracks.played.contains(1));
  EXPECT_EQ(tracks.foreign, std::vector<std::string>{"/io/variables"});
}

TEST(Tracks, ATopicOfSeveralWritersIsNamedOnce) {
  const auto tracks = tracks_of(recording_with({{"/io/state", "galilean_msgs/msg/RobotState"},
                                                {"/io/state", "galilean_msgs/msg/RobotState"},
                                                {"/team/command", "galilean_msgs/msg/Command"},
                                                {"/team/command", "galilean_msgs/msg/Command"},
                                                {"/scan", "sensor_msgs/msg/LaserScan"},
                                                {"/scan", "sensor_msgs/msg/LaserScan"}}));
  EXPECT_EQ(tracks.played.size(), 2u);  // of which each keeps for late joiners what its writer did
  EXPECT_EQ(topics_played(tracks), 1u);
  EXPECT_EQ(tracks.commands, std::vector<std::string>{"/team/command"});
  EXPECT_EQ(tracks.foreign, std::vector<std::string>{"/scan"});
}

TEST(Tracks, AProcessThatWasStartedAnewIsOneSender) {
  auto recording = recording_with({{"/io/state", "galilean_msgs/msg/RobotState"},
                                   {"/io/state", "galilean_msgs/msg/RobotState"},
                                   {"/io/state", "galilean_msgs/msg/RobotState"}});
  recording.channels[1].metadata = {{"process", "io"}, {"writer", "a"}};
  recording.channels[2].metadata = {{"process", "io"}, {"writer", "b"}};
  const auto played = tracks_of(recording).played;
  EXPECT_EQ(played.at(1).sender, played.at(2).sender);
  EXPECT_NE(played.at(1).sender, played.at(3).sender);
}

TEST(Tracks, WhatTheRecorderTellsOfItselfIsNoTopicOfTheTeam) {
  auto recording = recording_with({{"/recorder/losses", "galilean.Losses"}});
  EXPECT_TRUE(tracks_of(recording).foreign.empty());
  EXPECT_TRUE(tracks_of(recording).played.empty());
}

TEST(Tracks, ARecordedClockIsLeftOutWhereTheReplayTellsTheTime) {
  const auto recording = recording_with(
      {{"/clock", "rosgraph_msgs/msg/Clock"}, {"/io/state", "galilean_msgs/msg/RobotState"}});
  auto tracks = tracks_of(recording);
  EXPECT_EQ(tracks.played.size(), 2u);
  leave_out_clock(tracks);
  ASSERT_EQ(tracks.played.size(), 1u);
  EXPECT_EQ(tracks.played.at(2).topic, "rt/io/state");
  EXPECT_NE(before_playing("run.mcap", recording, tracks).find("not played: /clock; "),
            std::string::npos);
}

TEST(Report, SaysWhatIsPlayedAndWhatIsNot) {
  auto recording = recording_with({{"/io/state", "galilean_msgs/msg/RobotState"},
                                   {"/team/command", "galilean_msgs/msg/Command"}});
  recording.closed = false;
  recording.statistics.messages = 7;
  const auto text = before_playing("run.mcap", recording, tracks_of(recording));
  EXPECT_NE(text.find("run.mcap was not closed properly; recovered 7 messages\n"),
            std::string::npos);
  EXPECT_NE(text.find("not played: /team/command; "), std::string::npos);
  EXPECT_EQ(listed({"io", "ganymede", "callisto"}), "io, ganymede and callisto");
}

TEST(Report, SaysWhoIsPlayedAndWhoIsLive) {
  EXPECT_EQ(who_is_where({"callisto", "ganymede", "io"}, {"ganymede", "io"},
                         {.live = {"callisto"}, .played = {"europa"}}),
            "robots from the recording: ganymede and io\n"
            "robots left out of it: callisto\n"
            "live robots in this domain: callisto\n"
            "robots of another replay: europa\n");
  EXPECT_EQ(who_is_where({"io"}, {"io"}, {}),
            "robots from the recording: io\nlive robots in this domain: none\n");
}

TEST(Report, NeverCallsARobotOfAnotherReplayLive) {
  EXPECT_EQ(why_not_beside({.played = {"io"}}).find("io is played by another replay"), 0u);
  EXPECT_EQ(why_not_beside({.live = {"ganymede", "io"}}).find("ganymede and io are live"), 0u);
}

}  // namespace
}  // namespace galilean::monitor
