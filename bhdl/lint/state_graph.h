// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "bhdl/program/program.h"
#include "bhdl/source/diagnostic.h"

namespace galilean::bhdl {

/// Which states a program gets to, and by which way: from its start state, else from where a swap
/// leads to. Views point into the program.
class StateGraph {
  static constexpr std::size_t kNever = static_cast<std::size_t>(-1);

 public:
  explicit StateGraph(const Program& program);

  /// Of a state that exists, counted as in Program::states.
  [[nodiscard]] std::size_t index(std::string_view state) const { return indices_.at(state); }
  /// The target state of each condition of a state, in the order of the text.
  [[nodiscard]] const std::vector<std::size_t>& targets(std::size_t state) const noexcept {
    return targets_[state];
  }
  [[nodiscard]] bool reached(std::size_t state) const noexcept { return before_[state] != kNever; }
  [[nodiscard]] std::size_t reached_states() const noexcept { return order_.size(); }
  /// A shortest way to a state that is reached: "start → wander → grab". Long ones lose their
  /// middle.
  [[nodiscard]] std::string way_to(std::size_t state) const;
  /// The states on that way with their places, for clients that can show places.
  [[nodiscard]] std::vector<RelatedPlace> places_on_way_to(std::size_t state) const;

 private:
  /// Stands in a shortened way for the states that were left out.
  static constexpr std::size_t kLeftOut = kNever;
  [[nodiscard]] std::vector<std::size_t> short_way_to(std::size_t state) const;

  void explore_from(std::size_t beginning);
  void enter(std::size_t state, std::size_t from);

  const Program& program_;
  std::unordered_map<std::string_view, std::size_t> indices_;
  std::vector<std::vector<std::size_t>> targets_;
  std::vector<std::size_t> before_;  ///< itself where the program begins
  std::vector<std::size_t> order_;   ///< in which they were reached
};

}  // namespace galilean::bhdl
