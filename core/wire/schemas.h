// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string_view>

namespace galilean::wire {

/// One message type under the names that others know it by, and its definition.
struct Schema {
  std::string_view ros_type;  ///< "galilean_msgs/msg/RobotState"
  std::string_view dds_type;  ///< "galilean_msgs::msg::dds_::RobotState_", as ROS 2 registers it
  std::string_view idl;       ///< it and all types that it uses: encoding "ros2idl"
};

[[nodiscard]] std::span<const Schema> schemas() noexcept;
/// Both return nullptr if no message has that name.
[[nodiscard]] const Schema* find_schema_by_ros_type(std::string_view ros_type) noexcept;
[[nodiscard]] const Schema* find_schema_by_dds_type(std::string_view dds_type) noexcept;

}  // namespace galilean::wire
