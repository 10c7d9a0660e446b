// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/wire/delivery.h"
#include "monitor/mcap/mcap_reader.h"

namespace galilean::monitor {

/// One topic of a recording that can be sent again.
struct Track {
  std::string topic;     ///< DDS' name of it: "rt/io/state"
  std::string ros_type;  ///< "galilean_msgs/msg/RobotState"
  wire::Delivery delivery = wire::Delivery::kStream;
  /// Whose messages they are. Those of one topic and sender are sent by one writer, so that a
  /// process that was started anew replaces what it kept for late joiners before.
  std::string sender;
};

/// The topics of a recording that are sent again, and those that are not. The latter have their ROS
/// names: "/team/command".
struct Tracks {
  std::map<std::uint16_t, Track> played;  ///< by channel id
  std::vector<std::string> commands;      ///< orders to robots, which are never sent again
  bool has_other_clock = false;           ///< a recorded /clock, which is left out
  std::vector<std::string> foreign;       ///< topics whose type this release does not know, or
                                          ///< defines otherwise
  /// What the ticks of robots read, by channel id. It is run again and not sent again.
  std::map<std::uint16_t, Track> inputs;
};

/// Sorts a recording's channels into the four kinds. What the recorder tells of itself is in none.
[[nodiscard]] Tracks tracks_of(const mcap::Summary& summary);

/// Takes a recorded /clock out of what is sent again, because the replay tells the time itself.
void leave_out_clock(Tracks& tracks);
/// Returns the names of the robots among what is sent again: those that tell their state.
[[nodiscard]] std::set<std::string> robots_of(const Tracks& tracks);
/// Returns whether the message is one of this robot: on a topic of its own, or on a shared one.
[[nodiscard]] bool is_of(const Track& track, const std::string& robot);
/// Returns the number of topics that are sent again. Each writer of a topic has a channel.
[[nodiscard]] std::size_t topics_played(const Tracks& tracks);
/// Returns whether a monitor makes the topic from the robots' messages.
[[nodiscard]] bool is_made_by_monitor(const Track& track);
/// Returns whether several processes may write the topic at once, as ROS 2's own tools expect.
[[nodiscard]] bool is_shared(const Track& track);

}  // namespace galilean::monitor
