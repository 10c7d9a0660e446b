// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/keys/security_documents.h"

#include <gmock/gmock.h>

#include "core/wire/topic_names.h"

namespace galilean::monitor {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string grant_of(MemberRole role, const std::string& name) {
  return permissions_xml({.name = name,
                          .subject = "OU=0123,CN=" + name,
                          .rights = rights_of(role, name),
                          .from_s = 0,
                          .until_s = 86400});
}

/// The part of a grant that lists what is written, or read.
std::string part(const std::string& xml, const std::string& what) {
  const auto begin = xml.find("<" + what + ">"), end = xml.find("</" + what + ">");
  return begin == xml.npos || end == xml.npos ? std::string() : xml.substr(begin, end - begin);
}

TEST(MemberRole, EachHasItsNameAndNoOtherIsOne) {
  for (const auto role : kMemberRoles) EXPECT_EQ(member_role(name_of(role)), role);
  EXPECT_EQ(member_role(""), std::nullopt);
  EXPECT_EQ(member_role("Robot"), std::nullopt);
}

TEST(MemberRole, ARobotWritesItsOwnTopicsAndReadsOrders) {
  const auto rights = rights_of(MemberRole::kRobot, "io");
  EXPECT_THAT(rights.writes, Contains("rt/io/*"));
  EXPECT_THAT(rights.writes, Not(Contains(std::string(wire::kCommandTopic))));
  EXPECT_THAT(rights.writes, Not(Contains("*")));
  EXPECT_THAT(rights.reads, Contains(std::string(wire::kCommandTopic)));
  EXPECT_THAT(rights.reads, Contains(std::string(wire::kProgramPushTopic)));
  EXPECT_THAT(rights.reads, Contains("rt/io/state")) << "another robot of its name may be there";
}

TEST(MemberRole, AMonitorReadsAllAndWritesNoRobotsTopics) {
  const auto rights = rights_of(MemberRole::kMonitor, "monitor");
  EXPECT_THAT(rights.reads, Contains("*"));
  for (const char* topic : {wire::kCommandTopic, wire::kMapTopic, wire::kSimulationOrderTopic,
                            wire::kLeaseChangeTopic, wire::kDiagnosticsTopic})
    EXPECT_THAT(rights.writes, Contains(std::string(topic)));
  for (const auto& topic : rights.writes) EXPECT_NE(topic.substr(0, 4), "rt/*") << topic;
}

TEST(MemberRole, AViewerWritesNothingAndReadsNoOrders) {
  const auto rights = rights_of(MemberRole::kViewer, "anna");
  EXPECT_THAT(rights.writes, IsEmpty());
  EXPECT_THAT(rights.reads, Contains("rt/*/state"));
  EXPECT_THAT(rights.reads, Contains(std::string(wire::kLeaseChangeTopic)));
  for (const char* topic : {wire::kCommandTopic, wire::kProgramPushTopic, wire::kBreakOrderTopic})
    EXPECT_THAT(rights.reads, Not(Contains(std::string(topic))));
  EXPECT_THAT(rights.reads, Not(Contains("*")));
}

TEST(SecurityDocuments, AGrantNamesItsMemberItsTimesAndItsTopics) {
  const auto xml = grant_of(MemberRole::kRobot, "io");
  EXPECT_THAT(xml, AllOf(HasSubstr("<subject_name>OU=0123,CN=io</subject_name>"),
                         HasSubstr("<not_before>1970-01-01T00:00:00Z</not_before>"),
                         HasSubstr("<not_after>1970-01-02T00:00:00Z</not_after>"),
                         HasSubstr("<default>DENY</default>")));
  EXPECT_THAT(part(xml, "publish"), HasSubstr("<topic>rt/io/*</topic>"));
  EXPECT_THAT(part(xml, "publish"), Not(HasSubstr("rt/team/command")));
  EXPECT_THAT(part(xml, "subscribe"), HasSubstr("<topic>rt/team/command</topic>"));
}

TEST(SecurityDocuments, WhoWritesNothingHasNoSuchPart) {
  const auto xml = grant_of(MemberRole::kViewer, "anna");
  EXPECT_THAT(xml, Not(HasSubstr("publish")));
  EXPECT_THAT(part(xml, "subscribe"), HasSubstr("<topic>rt/*/state</topic>"));
}

// Cyclone's access control refuses a document as a whole that names a higher domain.
TEST(SecurityDocuments, EachIsForAllDomainsThatCanBeSecuredAndNoOther) {
  for (const auto& xml : {governance_xml(), grant_of(MemberRole::kRobot, "io")})
    EXPECT_THAT(xml,
                HasSubstr("<domains><id_range><min>0</min><max>230</max></id_range></domains>"));
}

TEST(SecurityDocuments, TheGovernanceLetsNobodyInUnauthenticated) {
  EXPECT_THAT(
      governance_xml(),
      AllOf(HasSubstr("<allow_unauthenticated_participants>false<"),
            HasSubstr("<enable_join_access_control>true<"),
            HasSubstr("<discovery_protection_kind>ENCRYPT<"),
            HasSubstr("<rtps_protection_kind>SIGN<"), HasSubstr("<data_protection_kind>ENCRYPT<"),
            HasSubstr("<enable_read_access_control>true<"),
            HasSubstr("<enable_write_access_control>true<"), Not(HasSubstr(">false</enable"))));
}

}  // namespace
}  // namespace galilean::monitor
