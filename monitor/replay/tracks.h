// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/wire/delivery.h"
#include "monitor/mcap/mcap_reader.h"

namespace galilean::monitor {

/// One topic of a recording that can be sent again.
struct Track {
  std::string topic;     ///< as on DDS: "rt/io/state"
  std::string ros_type;  ///< "galilean_msgs/msg/RobotState"
  wire::Delivery delivery = wire::Delivery::kStream;
};

/// The topics of a recording that are sent again, and those that are not. The latter are named as
/// ROS 2 names them: "/team/command".
struct Tracks {
  std::map<std::uint16_t, Track> played;  ///< by channel
  std::vector<std::string> commands;      ///< orders to robots, which are never sent again
  std::vector<std::string> foreign;       ///< of a type that this release does not know, or knows
                                          ///< otherwise
};

/// Sorts the channels of a recording into these three kinds.
[[nodiscard]] Tracks tracks_of(const mcap::Summary& summary);

/// Returns whether a monitor writes such a topic itself, from the robots' messages.
[[nodiscard]] bool is_made_by_monitor(const Track& track);
/// Returns whether several processes may write the topic at once, as ROS 2's own tools expect.
[[nodiscard]] bool is_shared(const Track& track);

}  // namespace galilean::monitor
