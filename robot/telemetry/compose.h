// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wire/messages.h"
#include "robot/executive/description.h"
#include "robot/executive/snapshot.h"
#include "robot/telemetry/wall_time.h"
#include "robot/telemetry/words.h"

namespace galilean::robot {

/// Makes messages from snapshots and events. Names come from the description of the program to
/// which the snapshot or event belongs.
class Composer {
 public:
  Composer(std::string robot, const Clock& clock) : robot_(std::move(robot)), wall_(clock) {}

  void refresh_time() noexcept { wall_.refresh(); }

  /// `program` is null if no program runs.
  [[nodiscard]] msg::RobotState state(const Snapshot& snapshot, const Description* program,
                                      const std::vector<Problem>& problems) const;
  [[nodiscard]] msg::Variables variables(const Snapshot& snapshot,
                                         const Description& program) const;
  [[nodiscard]] msg::Forces forces(const Snapshot& snapshot, const Description& program) const;
  [[nodiscard]] msg::Sightings sightings(const Snapshot& snapshot,
                                         const Description& program) const;
  [[nodiscard]] msg::Odometry odometry(const Snapshot& snapshot) const;
  [[nodiscard]] msg::TFMessage transform(const Snapshot& snapshot) const;
  [[nodiscard]] msg::DiagnosticArray diagnostics(const Snapshot& snapshot,
                                                 const std::vector<Problem>& problems) const;
  /// `from` is the program that the transition left, `to` the one that it led to.
  [[nodiscard]] msg::Transition transition(const Event& event, const Description& from,
                                           const Description& to) const;
  [[nodiscard]] msg::Program program(const Description& program) const;
  [[nodiscard]] msg::Catalog catalog(const galilean::Catalog& catalog) const;

  [[nodiscard]] const std::string& robot() const noexcept { return robot_; }

 private:
  [[nodiscard]] msg::Header header(Time time, const std::string& frame) const;

  std::string robot_;
  WallTime wall_;
};

}  // namespace galilean::robot
