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

/// Returns a variable's certainty, from 0 to 1, when `age` has passed since the message with it
/// came: certainty(t) = max(0, certainty(0) - decay_per_s * t). It is 0 if the variable is invalid.
[[nodiscard]] double certainty_after(const msg::Variable& variable, Duration age) noexcept;

/// Numbers of transitions that follow one another, both ends included.
struct NumberRange {
  std::uint64_t first = 0, last = 0;

  bool operator==(const NumberRange&) const = default;
};

/// The newest messages of one robot, as they were received. Times are of the monitor's clock.
struct Robot {
  static constexpr std::size_t kTransitionsKept = 64;
  static constexpr std::size_t kFilledKept = 16;

  std::string name;
  Time heard{};                      ///< when its last message came
  std::optional<Time> replay_heard;  ///< when the last one that a replay sent came
  std::optional<msg::RobotState> state;
  Time state_received{};
  double clock_ahead_s = 0;  ///< its state's stamp, less the time at which this machine received it
  std::optional<msg::Program> program;
  std::optional<msg::Catalog> catalog;
  msg::Variables variables;
  Time variables_received{};
  std::deque<msg::Transition> transitions;  ///< the newest ones, by number, the oldest first
  /// Which transitions fill a gap in which it could not be heard: the newest ranges of them, the
  /// oldest first.
  std::vector<NumberRange> filled;
  std::optional<msg::Breaks> breaks;
  Time breaks_received{};
  /// The newest reply to a push, by the robot's ticks: it tells of a swap before the next state
  /// does.
  std::optional<msg::ProgramReply> program_reply;

  /// Returns the hash of the program that it runs, as it told last; empty if it has sent no state.
  [[nodiscard]] std::string running_hash() const;
  /// Returns whether the transition of that number fills a gap, as far as is remembered.
  [[nodiscard]] bool is_filled(std::uint64_t transition) const noexcept;
};

enum class Health {
  kWell,
  kTroubled,  ///< it reports problems, or one of its ticks took longer than the tick period
  kSilent     ///< no message came for longer than Team's `silent_after`
};
[[nodiscard]] std::string_view to_string(Health health) noexcept;

/// One robot at one instant, ready for display.
struct RobotStatus {
  std::string name;
  bool replayed = false;  ///< a recording plays it, as far as is known: it is not there
  Health health = Health::kWell;
  double age_s = 0;        ///< time since its last message
  bool has_state = false;  ///< it has sent its state; without, nothing is known up to `overruns`
  std::string state;
  double in_state_s = 0;
  double clock_ahead_s = 0;  ///< its clock, less this machine's; 0 where that is little
  std::string program_name;
  std::string program_hash;
  bool drifting = false;  ///< its program differs from the team's program
  bool held = false;
  /// Why a break point, a step, a lock or a fault keeps it; see break_reason. Empty: none does, or
  /// it is silent, so that nobody knows.
  std::string break_reason;
  bool out_of_service = false;  ///< an operator decommissioned it
  bool in_probation = false;
  std::uint64_t tick = 0;
  double tick_time_us = 0;
  double tick_time_max_us = 0;
  double tick_period_s = 0;
  std::uint32_t overruns = 0;
  /// The least certain valid variable; empty if no variable is valid.
  std::string least_certain;
  double lowest_certainty = 1;
  double x_m = 0, y_m = 0, heading_rad = 0;  ///< its pose in its own odom frame
  std::vector<std::string> problems;
};

}  // namespace galilean::monitor
