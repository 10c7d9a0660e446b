// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "robot/rerun/recorded_robot.h"

namespace galilean::robot {

/// The first tick that led to something else, and why.
struct Divergence {
  std::uint64_t tick = 0;
  double at_s = 0;                   ///< by the robot's clock, whose zero is its start
  std::string cause;                 ///< the first part of the tick that went another way
  std::vector<std::string> details;  ///< what differs, in the order in which it came about
};

/// Compares what a recorded tick led to with what it leads to in `again`, which runs the same
/// program. Returns nothing if no bit differs.
[[nodiscard]] std::optional<Divergence> compare(const msg::TickOutcome& recorded,
                                                const RecordedRobot& again);

/// Compares the newest tick of a robot that runs the recorded program with that of one which runs
/// another. Variables go by name and type. Returns nothing if no bit of what both have differs.
[[nodiscard]] std::optional<Divergence> compare(const RecordedRobot& recorded,
                                                const RecordedRobot& other);

}  // namespace galilean::robot
