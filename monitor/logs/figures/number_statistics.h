// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace galilean::logs {

/// Count, range, mean and standard deviation of numbers, one at a time (Welford).
class NumberStatistics {
 public:
  void add(double number) noexcept {
    least_ = count_ == 0 ? number : std::min(least_, number);
    most_ = count_ == 0 ? number : std::max(most_, number);
    const long double before = number - mean_;
    mean_ += before / static_cast<long double>(++count_);
    squares_ += before * (number - mean_);
  }
  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
  [[nodiscard]] double least() const noexcept { return least_; }
  [[nodiscard]] double most() const noexcept { return most_; }
  [[nodiscard]] double mean() const noexcept { return static_cast<double>(mean_); }
  /// Returns the deviation of the population.
  [[nodiscard]] double deviation() const noexcept {
    return count_ == 0
               ? 0
               : static_cast<double>(std::sqrt(squares_ / static_cast<long double>(count_)));
  }

 private:
  std::uint64_t count_ = 0;
  double least_ = 0, most_ = 0;
  long double mean_ = 0, squares_ = 0;  ///< the square of a large double is none
};

}  // namespace galilean::logs
