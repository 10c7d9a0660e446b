// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/latest.h"
#include "core/memory.h"
#include "core/result.h"
#include "robot/executive/break_point.h"

namespace galilean::robot {

/// The break points of a robot. Other threads change them, and the control loop reads them without
/// waiting, allocating or freeing: a table is written in a place that it does not read
/// (core/latest.h). They go by the names of states, and so they outlive the program that runs.
/// Every method says which side may call it.
class Breaks {
 public:
  static constexpr std::size_t kTablesKept = 64;

  /// Any thread but control, as for all methods down to `refresh`. Adds the points, each in place
  /// of the one of the same two states. Errors: there would be more than BreakTable::kMostPoints,
  /// or a point names no state; then nothing changes.
  [[nodiscard]] Result<void> set(const std::vector<BreakPoint>& points);
  /// Takes off the points of the same two states. Errors: there is none of them.
  [[nodiscard]] Result<void> remove(const std::vector<StateChange>& changes);
  void clear();
  /// Lets the locked transitions of these changes fire, once: until the state changes. `state` is
  /// the present one. Errors: one of the changes is not locked, or begins in another state; then
  /// nothing is let through.
  [[nodiscard]] Result<void> let_through(const std::vector<StateChange>& changes,
                                         std::string_view state);
  [[nodiscard]] std::vector<BreakPoint> points() const;
  /// Returns the point of that number, also if it was taken off a short time ago.
  [[nodiscard]] std::optional<BreakPoint> find(std::uint64_t number) const;
  /// Returns the table of that number, if it is one of the newest kTablesKept.
  [[nodiscard]] std::optional<BreakTable> table(std::uint64_t number) const;
  /// Puts a table in place as it is, with its numbers: one that was recorded.
  void replay(BreakTable table);

  /// Control, as for all methods below: takes the newest table over.
  void refresh() noexcept { table_.take(); }
  /// Returns the number of the table that was taken last.
  [[nodiscard]] std::uint64_t table_number() const noexcept { return table_.reading().number; }
  /// Returns whether a lock keeps the transition from firing.
  [[nodiscard]] bool is_locked(std::string_view from, std::string_view to) const noexcept;
  /// Returns the point that stops the robot at this change of state, or null. Of several it is one
  /// that stops the team, if there is such.
  [[nodiscard]] const BreakPoint* stop_at(std::string_view from,
                                          std::string_view to) const noexcept;
  /// Ends what `let_through` permitted so far.
  void end_passes() noexcept;
  /// Keeps what the control loop remembers of passes. The table is not in it.
  void keep(Memory& memory) noexcept { memory.keep(ended_passes_); }

 private:
  void set_one(BreakPoint point);
  void publish();

  mutable std::mutex mutex_;  ///< guards what the control loop never touches
  BreakTable kept_;
  std::deque<BreakPoint> taken_off_;  ///< the newest ones, the oldest first
  std::deque<BreakTable> tables_;     ///< the newest ones, the oldest first
  std::uint64_t last_point_ = 0;
  std::uint64_t last_pass_ = 0;
  Latest<BreakTable> table_;        ///< written under mutex_
  std::uint64_t ended_passes_ = 0;  ///< control: the passes up to this number are over
};

}  // namespace galilean::robot
