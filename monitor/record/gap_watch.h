// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/clock.h"
#include "core/wire/cut_off_watch.h"
#include "core/wire/endpoints.h"
#include "core/wire/reader.h"

namespace galilean::monitor {

/// Returns whether the writer sends events of a robot that fill a gap when the robot is heard
/// again: changes of state, or answers to pushes.
[[nodiscard]] bool is_robot_event(const wire::EndpointInfo& writer);

/// Tells which events of robots fill a gap in which the robot could not be heard. It goes by the
/// robots' states, which must be heard, too.
class GapWatch {
 public:
  /// Whoever writes to DDS can invent robots. Beyond so many, it forgets them all and begins anew.
  static constexpr std::size_t kMostRobots = 256;

  /// Notes a message, and returns whether it is an event that fills a gap. Requires: `now` does not
  /// go back.
  [[nodiscard]] bool note(const wire::EndpointInfo& writer, const wire::Received& received,
                          Time now);
  /// Returns whether a writer's messages tell when a robot can be heard.
  [[nodiscard]] static bool is_state(const wire::EndpointInfo& writer);
  /// Returns what is to be known of the writer of a robot's changes of state, to select it.
  /// Requires: `state` writes the robot's states.
  [[nodiscard]] static wire::EndpointInfo transitions_of(wire::EndpointInfo state);

 private:
  std::map<std::string, wire::CutOffWatch, std::less<>> robots_;  ///< by topic, without its leaf
};

}  // namespace galilean::monitor
