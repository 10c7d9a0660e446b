// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/playback/recorded_topics.h"

#include <gtest/gtest.h>

#include "core/wire/schemas.h"

namespace galilean::monitor {
namespace {

constexpr const char* kStateType = "galilean_msgs/msg/RobotState";

mcap::Summary recording() {
  mcap::Summary summary;
  const std::string idl(wire::find_schema_by_ros_type(kStateType)->idl);
  summary.schemas[1] = {1, kStateType, "ros2idl", "// in other words\n" + idl};
  summary.schemas[2] = {2, "other_msgs/msg/Thing", "ros2msg", "int32 a"};
  summary.channels[1] = {1, 1, "/io/state", "cdr", {{"writer", "a"}}};
  summary.channels[2] = {2, 1, "/io/state", "cdr", {{"writer", "b"}}};
  summary.channels[3] = {3, 2, "/thing", "cdr", {}};
  summary.channels[4] = {
      4, 2, "/kept", "cdr", {{"offered_qos_profiles", "- durability: transient_local\n"}}};
  summary.channels[5] = {5, 0, "/bare", "json", {}};
  summary.channels[6] = {6, 1, "/europa/state", "cdr", {}};
  return summary;
}

const RecordedTopic& named(const std::vector<RecordedTopic>& topics, const std::string& name) {
  for (const auto& topic : topics)
    if (topic.topic == name) return topic;
  throw std::runtime_error("no topic " + name);
}

TEST(RecordedTopics, AChannelOfEachWriterIsOneTopic) {
  const auto topics = recorded_topics(recording());
  ASSERT_EQ(topics.size(), 5u);
  EXPECT_EQ(named(topics, "/io/state").channels, (std::vector<std::uint16_t>{1, 2}));
  for (std::size_t i = 0; i < topics.size(); ++i) EXPECT_EQ(topics[i].id, i + 1);
}

TEST(RecordedTopics, KnownTypesAreDefinedAsLiveAndOthersAsInTheFile) {
  const auto topics = recorded_topics(recording());
  const auto& state = named(topics, "/io/state");
  EXPECT_EQ(state.schema_encoding, "ros2idl");
  EXPECT_EQ(state.schema, wire::find_schema_by_ros_type(kStateType)->idl);
  const auto& thing = named(topics, "/thing");
  EXPECT_EQ(thing.schema_encoding, "ros2msg");
  EXPECT_EQ(thing.schema, "int32 a");
  EXPECT_EQ(named(topics, "/bare").schema_name, "");
}

TEST(RecordedTopics, WhatAWriterKeptForLateJoinersIsAState) {
  const auto topics = recorded_topics(recording());
  EXPECT_EQ(named(topics, "/kept").delivery, wire::Delivery::kState);
  EXPECT_EQ(named(topics, "/thing").delivery, wire::Delivery::kStream);
  EXPECT_EQ(named(topics, "/io/state").delivery, wire::Delivery::kState);
}

TEST(RecordedTopics, RobotsAreThoseThatHaveAState) {
  const auto summary = recording();
  EXPECT_EQ(recorded_robots(summary.schemas, summary.channels),
            (std::vector<std::string>{"europa", "io"}));
}

}  // namespace
}  // namespace galilean::monitor
