// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/state_change.h"

namespace galilean::robot {

/// A change of state by the names of the two states. An empty name stands for any state.
struct StateChange {
  std::string from_state;
  std::string to_state;

  [[nodiscard]] bool matches(std::string_view from, std::string_view to) const noexcept {
    return (from_state.empty() || from_state == from) && (to_state.empty() || to_state == to);
  }
  /// Returns whether some change of state matches both.
  [[nodiscard]] bool overlaps(const StateChange& other) const noexcept {
    const auto agree = [](const std::string& a, const std::string& b) {
      return a.empty() || b.empty() || a == b;
    };
    return agree(from_state, other.from_state) && agree(to_state, other.to_state);
  }
  bool operator==(const StateChange&) const = default;
};

/// Returns "wander -> grab", "on entering grab" or "on leaving wander".
[[nodiscard]] inline std::string in_words(const StateChange& change) {
  return change_words(change.from_state, change.to_state);
}

enum class BreakKind : std::uint8_t {
  kStop,      ///< the robot stands still from the change of state on
  kStopTeam,  ///< so does every other robot
  kLock,      ///< the transition does not fire until an operator lets it through
};

/// Where a robot stops, or waits for an operator.
struct BreakPoint {
  StateChange at;
  BreakKind kind = BreakKind::kStop;
  std::string author = {};
  std::uint64_t number = 0;  ///< 1, 2, 3 … in the order in which they were set
};

/// An operator's permission to fire locked transitions.
struct LockPass {
  StateChange at;
  std::uint64_t number = 0;  ///< 1, 2, 3 … in the order in which they were given
};

/// All that the control loop reads of break points.
struct BreakTable {
  static constexpr std::size_t kMostPoints = 32;
  static constexpr std::size_t kMostPasses = 32;

  std::uint64_t number = 0;        ///< 1, 2, 3 … with each change; 0: nothing was set yet
  std::vector<BreakPoint> points;  ///< in the order in which they were set
  std::vector<LockPass> passes;    ///< the newest ones, the oldest first
};

}  // namespace galilean::robot
