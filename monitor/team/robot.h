// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// A variable's certainty, `age` after the Variables that carried it came:
/// certainty(t) = max(0, certainty(0) - decay_per_s * t); 0 while the variable is invalid.
[[nodiscard]] double certainty_after(const msg::Variable& variable, Duration age) noexcept;

/// The newest that is known of one robot, as it was received. Times are the monitor's own.
struct Robot {
  static constexpr std::size_t kTransitionsKept = 64;

  std::string name;
  Time heard{};  ///< when it last said anything
  std::optional<msg::RobotState> state;
  Time state_received{};
  std::optional<msg::Program> program;
  std::optional<msg::Catalog> catalog;
  msg::Variables variables;
  Time variables_received{};
  std::deque<msg::Transition> transitions;  ///< by number, the oldest first
};

enum class Health {
  kWell,
  kTroubled,  ///< it reports problems, or its ticks come late
  kSilent     ///< nothing heard for longer than the monitor waits
};
[[nodiscard]] std::string_view to_string(Health health) noexcept;

/// One robot at one instant, for whoever shows it.
struct RobotStatus {
  std::string name;
  Health health = Health::kWell;
  double age_s = 0;  ///< since it was last heard
  std::string state;
  double in_state_s = 0;
  std::string program_name;
  std::string program_hash;
  bool drifting = false;  ///< it runs another program than the team
  bool held = false;
  bool out_of_service = false;  ///< decommissioned
  bool in_probation = false;
  std::uint64_t tick = 0;
  double tick_time_us = 0;
  double tick_time_max_us = 0;
  double tick_period_s = 0;
  std::uint32_t overruns = 0;
  /// The name of the least certain valid variable; empty if no variable is valid.
  std::string least_certain;
  double lowest_certainty = 1;
  double x_m = 0, y_m = 0, heading_rad = 0;  ///< the robot's odom frame
  std::vector<std::string> problems;
};

}  // namespace galilean::monitor
