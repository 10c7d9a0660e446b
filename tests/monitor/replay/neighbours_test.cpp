// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/neighbours.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using Names = std::vector<std::string>;

constexpr const char* kStateOnDds = "galilean_msgs::msg::dds_::RobotState_";

wire::EndpointInfo writer(const std::string& topic, const std::string& process,
                          const std::string& dds_type = kStateOnDds) {
  return {.writes = true, .topic = topic, .dds_type = dds_type, .process = process};
}

std::map<std::uint16_t, Track> tracks_on(std::initializer_list<const char*> topics) {
  std::map<std::uint16_t, Track> tracks;
  for (const char* topic : topics)
    tracks[static_cast<std::uint16_t>(tracks.size() + 1)] = {.topic = topic};
  return tracks;
}

TEST(Neighbours, NamesakesAreThoseThatWriteTheSameTopics) {
  const auto tracks =
      tracks_on({"rt/io/state", "rt/io/program", "rt/referee/score", "rt/team/objects", "rt/tf"});
  const auto there = namesakes({writer("rt/io/state", "io"), writer("rt/io/program", "io"),
                                writer("rt/referee/score", "sim")},
                               tracks);
  EXPECT_EQ(there.live, (Names{"io", "referee"}));
  EXPECT_EQ(there.played, Names{});
  EXPECT_TRUE(namesakes({writer("rt/europa/state", "europa"), writer("rt/team/objects", "monitor"),
                         writer("rt/tf", "io")},
                        tracks)
                  .empty());
}

TEST(Neighbours, WhatAnotherReplayWritesIsNotLive) {
  const auto there = namesakes({writer("rt/io/state", "replay")}, tracks_on({"rt/io/state"}));
  EXPECT_EQ(there.live, Names{});
  EXPECT_EQ(there.played, Names{"io"});
}

TEST(Neighbours, RobotsAreThoseThatTellTheirState) {
  auto reader = writer("rt/europa/state", "monitor");
  reader.writes = false;
  const auto there =
      wire::robots_in({writer("rt/io/state", "io"), writer("rt/ganymede/state", "replay"), reader,
                       writer("rt/referee/score", "sim", "galilean_msgs::msg::dds_::Score_")});
  EXPECT_EQ(there.live, Names{"io"});
  EXPECT_EQ(there.played, Names{"ganymede"});
}

}  // namespace
}  // namespace galilean::monitor
