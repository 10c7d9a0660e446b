// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::logs {

/// What robots that ran one program did of it: which of its states they were in, and which of its
/// conditions led them from one state to another.
class ProgramCoverage {
 public:
  /// Takes what the program has. It may come after what was done of it, and again.
  void describe(const msg::Program& program);
  /// Takes that a robot is in a state.
  void note(const msg::RobotState& state);
  void note(const msg::Transition& transition);

  /// Returns the program's name, or its hash as long as no name is known.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] bool described() const noexcept { return !states_in_order_.empty(); }
  /// Returns which share of the states was visited, and of the conditions taken, from 0 to 1.
  /// Requires: the program was described.
  [[nodiscard]] double share_of_states() const;
  [[nodiscard]] double share_of_conditions() const;

  [[nodiscard]] monitor::MessageTree figures() const;
  /// Returns lines for people: shares, and what was never done.
  [[nodiscard]] std::string text() const;
  /// Returns the state machine for Graphviz, with how often each was done. What never was is
  /// dashed.
  [[nodiscard]] std::string dot() const;

 private:
  /// Where it stands, and what it is.
  struct Condition {
    std::string from, to, file;
    std::uint32_t line = 0;
    std::string variable;
    std::uint32_t bit = 0;
    bool value = false;
    auto operator<=>(const Condition&) const = default;  // NOLINT(modernize-use-nullptr): none here
    [[nodiscard]] std::string text() const;
  };
  struct Counts {
    std::uint64_t taken = 0;
    std::uint64_t held = 0;  ///< while one before it was taken
  };

  [[nodiscard]] std::size_t visited() const;
  [[nodiscard]] std::size_t taken() const;

  std::string name_;
  std::vector<std::string> states_in_order_;
  std::vector<Condition> conditions_in_order_;
  std::map<std::string, std::uint64_t> visits_;  ///< by state; 0: was in it, and no way in was seen
  std::map<Condition, Counts> counts_;
};

}  // namespace galilean::logs
