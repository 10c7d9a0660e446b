// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "bhdl/program/program.h"
#include "bhdl/source/diagnostic.h"

namespace galilean::bhdl {

/// Finds which states a program gets to, and by which way, from its start state or else from the
/// target of a swap. Views point into the program.
class StateGraph {
  static constexpr std::size_t kNever = static_cast<std::size_t>(-1);

 public:
  explicit StateGraph(const Program& program);

  /// Returns the state's index, counted as in Program::states. Requires: it exists.
  [[nodiscard]] std::size_t index(std::string_view state) const { return indices_.at(state); }
  /// Returns the target state of each condition of a state, in the order of the text.
  [[nodiscard]] const std::vector<std::size_t>& targets(std::size_t state) const noexcept {
    return targets_[state];
  }
  [[nodiscard]] bool reached(std::size_t state) const noexcept { return before_[state] != kNever; }
  [[nodiscard]] std::size_t reached_states() const noexcept { return order_.size(); }
  /// Returns a shortest way to a state: "start → wander → grab". Long ways lose their middle.
  /// Requires: the state is reached.
  [[nodiscard]] std::string way_to(std::size_t state) const;
  /// Returns the states on that way with their places, for clients that can show places.
  [[nodiscard]] std::vector<RelatedPlace> places_on_way_to(std::size_t state) const;

 private:
  /// Stands for the states that were left out of a shortened way.
  static constexpr std::size_t kLeftOut = kNever;
  [[nodiscard]] std::vector<std::size_t> short_way_to(std::size_t state) const;

  void explore_from(std::size_t beginning);
  void enter(std::size_t state, std::size_t from);

  const Program& program_;
  std::unordered_map<std::string_view, std::size_t> indices_;
  std::vector<std::vector<std::size_t>> targets_;
  std::vector<std::size_t> before_;  ///< the state before on the way; itself where the program
                                     ///< begins
  std::vector<std::size_t> order_;   ///< the states in the order in which they were reached
};

}  // namespace galilean::bhdl
