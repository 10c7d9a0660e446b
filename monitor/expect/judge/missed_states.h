// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>

#include "monitor/expect/judge/span_list.h"

namespace galilean::expect {

/// The transitions of a robot of which nothing was told, though later ones were: meanwhile it was
/// in states that are not known. Its memory is bounded.
class MissedStates {
 public:
  /// Takes that the transition `number` was told, after `before` as the newest. Those between
  /// happened at `when`.
  void pass(std::uint64_t before, std::uint64_t number, const Span& when);
  /// Takes that a transition was told after later ones. Returns whether it had been missed.
  [[nodiscard]] bool find(std::uint64_t number);
  /// Takes that the robot numbers its transitions from 1 again.
  void restart();

  /// Returns when the robot was in states that are not known.
  [[nodiscard]] SpanList times() const;

 private:
  static constexpr std::size_t kMost = 1000;

  std::map<std::uint64_t, Span> missed_;  ///< by number
  SpanList for_ever_;                     ///< those that are not looked for
};

}  // namespace galilean::expect
