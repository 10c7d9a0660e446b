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

/// What of a recording is sent again, and what is not. Topics of the latter as ROS 2 names them:
/// "/team/command".
struct Tracks {
  std::map<std::uint16_t, Track> played;  ///< by channel
  std::vector<std::string> commands;      ///< nobody is told a second time what to do
  std::vector<std::string> foreign;       ///< of a type that this release does not know, or knows
                                          ///< otherwise
};

[[nodiscard]] Tracks tracks_of(const mcap::Summary& summary);

/// Returns whether a monitor writes such a topic itself, from the robots' messages.
[[nodiscard]] bool is_made_by_monitor(const Track& track);
/// Returns whether several processes may write the topic at once, as ROS 2's own tools expect.
[[nodiscard]] bool is_shared(const Track& track);

}  // namespace galilean::monitor
