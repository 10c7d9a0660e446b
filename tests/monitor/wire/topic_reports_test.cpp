// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/qos_report.h"

#include <gtest/gtest.h>

#include "core/wire/types/own_types.h"
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

TEST(TopicReports, AReaderOfAllWritersAsksForNoMoreThanTheLeastOfThemOffers) {
  using enum wire::EndpointQos::Durability;
  EndpointInfo reliable = kWriter, persistent = kWriter;
  reliable.qos.reliable = true;
  reliable.qos.durability = kTransientLocal;
  persistent.qos.reliable = true;
  persistent.qos.durability = kPersistent;
  const auto both = least_qos(std::vector{persistent, reliable});
  EXPECT_TRUE(both.reliable);
  EXPECT_EQ(both.durability, kTransientLocal);
  const auto all = least_qos(std::vector{reliable, persistent, kWriter});
  EXPECT_FALSE(all.reliable);
  EXPECT_EQ(all.durability, kVolatile);
}

TEST(TopicReports, TellWhoseDefinitionOfATypeAnEndHas) {
  EndpointInfo end = kWriter;
  const auto told = [&] { return topic_info(std::vector{end})["writers"][0]["definition"]; };
  EXPECT_EQ(told(), "unpublished");
  end.type_hash = wire::find_own_type(end.dds_type)->hash;
  EXPECT_EQ(told(), "ours");
  EXPECT_EQ(topic_info_text(topic_info(std::vector{end})).find("definition"), std::string::npos);
  end.type_hash = std::string(28, '5');
  EXPECT_EQ(told(), "differs");
  EXPECT_NE(topic_info_text(topic_info(std::vector{end})).find("differs from ours"),
            std::string::npos);
  end.dds_type = "foreign::Plain";
  EXPECT_EQ(told(), "its own");
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
