// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/types/message_definition.h"

#include <gtest/gtest.h>

#include "core/wire/schemas.h"
#include "core/wire/types/own_types.h"
#include "tests/core/wire/types/foreign_talk.h"

namespace galilean::wire {
namespace {

const std::string kRule = std::string(80, '=') + "\n";

std::string definition_of_own(const std::string& dds_type) {
  return message_definition(find_own_type(dds_type)->description).value();
}

std::string why_not(Foreign message) {
  const auto type = describe_descriptor(foreign_descriptor(message)).value().description;
  const auto definition = message_definition(type);
  return definition ? "" : definition.error().message;
}

TEST(MessageDefinition, HasFieldsAsMsgFilesWriteThem) {
  EXPECT_EQ(definition_of_own("builtin_interfaces::msg::dds_::Time_"),
            "int32 sec\nuint32 nanosec\n");
}

TEST(MessageDefinition, IsFollowedByThoseOfTheMessagesInIt) {
  EXPECT_EQ(definition_of_own("std_msgs::msg::dds_::Header_"),
            "builtin_interfaces/Time stamp\nstring frame_id\n" + kRule +
                "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n");
}

TEST(MessageDefinition, ThereIsOneOfEveryMessageOfThisRelease) {
  for (const auto& schema : schemas())
    if (const auto* own = find_own_type(schema.dds_type)) {
      const auto definition = message_definition(own->description);
      EXPECT_TRUE(definition) << schema.ros_type << ' ' << definition.error().message;
    }
}

TEST(MessageDefinition, SaysWhatNoMsgFileCanSay) {
  EXPECT_EQ(why_not(Foreign::kSettings), "is a mutable struct");
  EXPECT_EQ(why_not(Foreign::kPlain),
            "has the field present_gear, which is of the type foreign::Gear, which is no message");
  EXPECT_EQ(why_not(Foreign::kReport),
            "has the field best, which is of the type foreign::Tag, which is no message");
}

TEST(MessageDefinition, TakesListsWithAndWithoutABound) {
  EXPECT_EQ(message_definition(
                describe_descriptor(foreign_descriptor(Foreign::kCells)).value().description)
                .value(),
            "int8 cost\nint8[] costs\nint8[4] corners\n");
}

}  // namespace
}  // namespace galilean::wire
