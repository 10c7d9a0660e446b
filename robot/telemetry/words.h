// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/executive/description.h"
#include "robot/executive/snapshot.h"

namespace galilean {
struct Devices;
}

namespace galilean::robot {

/// The texts that the operator reads about events of a tick.

/// Returns a cause such as "trash_seen[0] became 1", "program swapped" or "rolled back: …".
/// `from` is the program that the event left.
[[nodiscard]] std::string cause_of(const Event& transition, const Description& from);

/// Returns why a program was rolled back. `of` is that program.
[[nodiscard]] std::string fault_of(const Event& rollback, const Description& of);

/// A fault of a device or of a schema, or that the robot is held after one.
struct Problem {
  std::string subject;   ///< the name of a device or of a schema, or "held"
  std::string sentence;  ///< what is wrong and what to do

  [[nodiscard]] std::string text() const { return subject + ": " + sentence; }
  bool operator==(const Problem&) const = default;
};

/// Returns why a fault holds the robot and what to do, such as "held: the serial line was gone for
/// 3.2 s; resume it, or push a bumper.". Returns nothing if no fault holds it.
[[nodiscard]] std::optional<Problem> hold_of(const Snapshot& snapshot);

/// Returns all that is wrong now: a fault after which the robot is held, devices that do not
/// answer, and schemas that threw. `program` may be null. Requires: the caller is not the control
/// loop, because it asks the devices.
[[nodiscard]] std::vector<Problem> problems_of(const Snapshot& snapshot, const Description* program,
                                               const Devices& devices);

}  // namespace galilean::robot
