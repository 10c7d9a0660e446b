// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/selection.h"

#include <gtest/gtest.h>

#include <string>

namespace galilean::monitor {
namespace {

wire::EndpointInfo writer_of(const std::string& topic) {
  wire::EndpointInfo end;
  end.writes = true;
  end.topic = topic;
  end.dds_type = "galilean_msgs::msg::dds_::RobotState_";
  return end;
}

wire::EndpointInfo picture_of(const std::string& topic) {
  auto end = writer_of(topic);
  end.dds_type = "sensor_msgs::msg::dds_::CompressedImage_";
  return end;
}

TEST(Selection, TakesEveryTopicUnlessToldOtherwise) {
  const Selection all;
  for (const char* topic : {"rt/io/state", "rt/scan", "plain_dds_topic"})
    EXPECT_TRUE(all.takes(writer_of(topic))) << topic;
  EXPECT_TRUE(all.takes(picture_of("rt/io/superred/compressed")));
}

TEST(Selection, TakesTheInputsOfRobotsOnlyIfTheyAreAskedFor) {
  auto inputs = writer_of("rt/io/inputs");
  inputs.dds_type = "galilean_msgs::msg::dds_::TickInputs_";
  Selection some;
  EXPECT_FALSE(some.takes(inputs));
  some.topics.emplace_back("inputs");
  EXPECT_FALSE(some.takes(inputs)) << "robots would begin to send them";
  some.inputs = true;
  EXPECT_TRUE(some.takes(inputs));
}

TEST(Selection, TakesInputsBesideTheTopicsThatAreChosen) {
  auto inputs = writer_of("rt/io/inputs");
  inputs.dds_type = "galilean_msgs::msg::dds_::TickInputs_";
  Selection some;
  some.inputs = true;
  some.topics.emplace_back("state");
  EXPECT_TRUE(some.takes(inputs));
  EXPECT_FALSE(some.excludes_inputs_of_all());
  some.excluded.emplace_back("^/io/");
  EXPECT_FALSE(some.takes(inputs));
  EXPECT_FALSE(some.excludes_inputs_of_all()) << "other robots may send some";
  some.excluded.emplace_back("inputs$");
  EXPECT_TRUE(some.excludes_inputs_of_all());
}

TEST(Selection, LeavesServicesOut) {
  EXPECT_FALSE(Selection().takes(writer_of("rq/talker/set_parametersRequest")));
  EXPECT_FALSE(Selection().takes(writer_of("rr/talker/set_parametersReply")));
}

TEST(Selection, TakesWhatOneOfTheExpressionsMatchesByItsRosName) {
  Selection some;
  some.topics.emplace_back("^/io/");
  some.topics.emplace_back("score$");
  EXPECT_TRUE(some.takes(writer_of("rt/io/state")));
  EXPECT_TRUE(some.takes(writer_of("rt/referee/score")));
  EXPECT_FALSE(some.takes(writer_of("rt/europa/state")));
}

TEST(Selection, WhatIsExcludedIsLeftOutEvenIfItIsAskedFor) {
  Selection some;
  some.topics.emplace_back("^/io/");
  some.excluded.emplace_back("variables");
  some.excluded.emplace_back("forces");
  EXPECT_TRUE(some.takes(writer_of("rt/io/state")));
  EXPECT_FALSE(some.takes(writer_of("rt/io/variables")));
  EXPECT_FALSE(some.takes(writer_of("rt/io/forces")));
}

TEST(Selection, TakesPicturesOfCamerasAloneOrNone) {
  Selection some;
  some.pictures = Pictures::kCamera;
  EXPECT_TRUE(some.takes(picture_of("rt/io/camera/compressed")));
  EXPECT_FALSE(some.takes(picture_of("rt/io/superred/compressed")));
  some.pictures = Pictures::kNone;
  EXPECT_FALSE(some.takes(picture_of("rt/io/camera/compressed")));
  EXPECT_TRUE(some.takes(writer_of("rt/io/state")));
}

}  // namespace
}  // namespace galilean::monitor
