// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "core/clock.h"

namespace galilean::monitor {

/// How often messages come, and how evenly (Welford's running mean and variance of the gaps).
class GapStatistics {
 public:
  struct Figures {
    double rate_hz, least_s, most_s, mean_s, deviation_s, bytes_per_s;
  };

  void add(Time received, std::size_t bytes) noexcept;
  [[nodiscard]] std::size_t messages() const noexcept { return messages_; }
  /// Returns nothing until there are two messages at different times. The deviation is that of the
  /// gaps' population. The first message's bytes do not count, because no gap is before it.
  [[nodiscard]] std::optional<Figures> figures() const;

 private:
  std::size_t messages_ = 0;
  std::size_t bytes_ = 0;  ///< of all but the first
  Time first_{}, last_{};
  double least_s_ = 0, most_s_ = 0, mean_s_ = 0, squares_s2_ = 0;
};

}  // namespace galilean::monitor
