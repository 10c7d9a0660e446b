// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/wire/messages.h"

namespace galilean::robot {

/// What a robot tells the others when one of its break points stops the whole team. It goes out as
/// a command to hold, whose id begins with "break:", so that a step may let the others go again.
struct TeamStop {
  std::string robot;        ///< the one whose break point it is
  std::string break_point;  ///< in words, such as "break point wander -> grab"
  std::string author;       ///< who set it
};

/// `transition` is the number of the transition that stopped the robot.
[[nodiscard]] msg::Command command_of(const TeamStop& stop, std::uint64_t transition);
/// Returns nothing if the command is not such a one.
[[nodiscard]] std::optional<TeamStop> team_stop_in(const msg::Command& command);

}  // namespace galilean::robot
