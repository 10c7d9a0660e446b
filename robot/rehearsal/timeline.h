// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "robot/executive/tick_observer.h"

namespace galilean::robot {

/// Records which state of a program was current at which time of a run.
class Timeline final : public TickObserver {
 public:
  struct Stay {
    std::uint32_t state = 0;
    double from_s = 0;                       ///< since the first tick
    std::uint32_t condition = Event::kNone;  ///< index of the condition of the state before that
                                             ///< led here
  };

  /// Requires: the program is about to start, and outlives this.
  explicit Timeline(const bhdl::Program& program);

  void on_event(const Event& event) noexcept override;
  void on_tick(const TickView&) noexcept override {}

  [[nodiscard]] const std::vector<Stay>& stays() const noexcept { return stays_; }
  [[nodiscard]] const std::string& state_name(const Stay& stay) const {
    return program_.states[stay.state].name;
  }
  /// Returns the stay that began last, at that time or before.
  [[nodiscard]] const Stay& at(double time_s) const;
  /// Returns "2.35 s: wander → back_up, since bumpers[0] is 1", or "0 s: starts in wander" for
  /// the first stay.
  [[nodiscard]] std::string in_words(std::size_t stay) const;
  /// Returns which schema failed first, when, and what it threw, or an empty text if none failed.
  [[nodiscard]] const std::string& failure() const noexcept { return failure_; }

 private:
  const bhdl::Program& program_;
  std::vector<Stay> stays_;
  std::string failure_;
};

}  // namespace galilean::robot
