// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace galilean::wire {

/// Tells what is missing of a writer's messages, and what comes again, by the numbers that the
/// writer gave them: they rise by one with each message, from 1, and come in that order.
class SequenceTally {
 public:
  /// Takes note of a message, whose number is 0 if it is not known. Returns false if it has come
  /// before, as what is kept for late joiners does after a writer was out of reach.
  [[nodiscard]] bool note(std::uint64_t sequence) noexcept;

  /// Returns how many have come, each counted once.
  [[nodiscard]] std::uint64_t received() const noexcept { return received_; }
  /// Returns how many have not come of those between the first and the last that came.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }
  /// Returns how many had been sent before the first that came.
  [[nodiscard]] std::uint64_t sent_before() const noexcept { return first_ > 0 ? first_ - 1 : 0; }

 private:
  std::uint64_t first_ = 0, last_ = 0;  ///< 0: none has come yet
  std::uint64_t received_ = 0, lost_ = 0;
};

}  // namespace galilean::wire
