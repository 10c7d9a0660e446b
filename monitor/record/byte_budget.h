// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/clock.h"

namespace galilean::monitor {

/// Lets so many bytes a second through, on the average. What is larger than a second's worth passes
/// alone, and is waited for afterwards.
class ByteBudget {
 public:
  /// 0: without a limit.
  explicit ByteBudget(std::uint64_t bytes_per_s) noexcept
      : bytes_per_s_(static_cast<double>(bytes_per_s)), left_(bytes_per_s_) {}

  /// Returns whether something of this size passes at `now`.
  [[nodiscard]] bool takes(std::size_t bytes, Time now) noexcept {
    if (bytes_per_s_ == 0) return true;
    left_ = std::min(bytes_per_s_, left_ + bytes_per_s_ * to_seconds(now - filled_));
    filled_ = now;
    if (left_ <= 0) return false;
    left_ -= static_cast<double>(bytes);
    return true;
  }

 private:
  double bytes_per_s_;
  double left_;    ///< bytes; below 0: too much has passed
  Time filled_{};  ///< when `left_` was reckoned
};

}  // namespace galilean::monitor
