// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/wire/endpoints.h"

namespace galilean::monitor {

/// Returns a topic's name as users know it: "/io/state" for "rt/io/state". What is no topic of
/// ROS 2 keeps its name.
[[nodiscard]] std::string shown_topic(std::string_view dds_topic);

/// Returns a type's name as users know it: "galilean_msgs/msg/RobotState" for
/// "galilean_msgs::msg::dds_::RobotState_". Other types keep their names.
[[nodiscard]] std::string shown_type(std::string_view dds_type);

/// Returns whether a user means this topic, with or without a slash or "rt/" before the name.
[[nodiscard]] bool names_topic(std::string_view user, std::string_view dds_topic);

/// Returns the sentence for a topic that nobody writes or reads, with what may have been meant.
[[nodiscard]] std::string unknown_topic(std::string_view user,
                                        std::span<const wire::EndpointInfo> known);

}  // namespace galilean::monitor
