// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// Which robots and topics are played, and under which names.
struct Choice {
  /// A topic and the name under which it is played: "/io/state" and "/europa/state".
  struct Renamed {
    std::string topic, name;
  };
  /// Only what these sent; none: everybody. What several make together, such as the score, is left
  /// out.
  std::vector<std::string> robots;
  std::vector<std::string>
      topics;  ///< of these robots; with or without the leading slash; none: all
  std::vector<Renamed> renamed;
};

/// Reads "/io/state:=/europa/state". Slashes at the beginning may be left out.
/// Errors: it is something else, or no name of a topic in ROS; the error is a sentence.
[[nodiscard]] Result<Choice::Renamed> read_renamed(const std::string& text);

/// Leaves of the tracks what was chosen, under the names that were chosen.
/// Errors: a robot or a topic is not among those that can be played; the message says what may have
/// been meant. Or nothing is left.
[[nodiscard]] Result<void> choose(const Choice& choice, Tracks& tracks);

}  // namespace galilean::monitor
