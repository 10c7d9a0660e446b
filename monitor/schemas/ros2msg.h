// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "monitor/schemas/definitions.h"

namespace galilean::monitor {

/// Reads a schema in MCAP's encoding "ros2msg": the text of a .msg file, and those that it needs,
/// each behind a line of = and one that names it ("MSG: geometry_msgs/Point").
/// @param type  the name of the first: "geometry_msgs/msg/Pose"
/// Errors: it is nothing of the kind; the error is a clause such as "has the line 'x', which …".
[[nodiscard]] Result<Definitions> parse_ros2msg(const std::string& type, std::string_view text);

/// Returns "geometry_msgs::msg::Pose" for "geometry_msgs/msg/Pose" and for "geometry_msgs/Pose".
[[nodiscard]] std::string scoped_name(std::string_view ros_type);

}  // namespace galilean::monitor
