// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/qos_report.h"

#include <gtest/gtest.h>

#include "monitor/wire/topic_name.h"
#include "monitor/wire/topic_reports.h"

namespace galilean::monitor {
namespace {

using wire::EndpointInfo;

const EndpointInfo kWriter{true, "rt/io/state", "galilean_msgs::msg::dds_::RobotState_", "io", {}};

TEST(TopicReports, AReaderThatAsksForMoreThanIsOfferedCannotMatch) {
  EndpointInfo reader = kWriter;
  reader.writes = false;
  EXPECT_TRUE(mismatches(kWriter, reader).empty());
  reader.qos.reliable = true;
  reader.qos.durability = wire::EndpointQos::Durability::kTransientLocal;
  EXPECT_EQ(mismatches(kWriter, reader).size(), 2U);
  reader.dds_type = "other";
  EXPECT_EQ(mismatches(kWriter, reader).size(), 3U);
  EXPECT_EQ(topic_info(std::vector{kWriter, reader})["mismatches"].size(), 1U);
}

TEST(TopicReports, TopicsAreNamedAsUsersKnowThem) {
  EXPECT_EQ(shown_topic("rt/io/state"), "/io/state");
  EXPECT_EQ(shown_type(kWriter.dds_type), "galilean_msgs/msg/RobotState");
  for (const char* name : {"io/state", "/io/state", "rt/io/state"})
    EXPECT_TRUE(names_topic(name, kWriter.topic)) << name;
  EXPECT_NE(unknown_topic("io/sttae", std::vector{kWriter}).find("did you mean '/io/state'?"),
            std::string::npos);
}

}  // namespace
}  // namespace galilean::monitor
