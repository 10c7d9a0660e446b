// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace galilean::logs {

/// The least and the most of some values.
struct ValueRange {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  [[nodiscard]] bool empty() const noexcept { return least > most; }
  void take(const ValueRange& other) noexcept;
};

/// Numbers over time, in bounded memory: the range of values in each of equal spans of time. The
/// spans grow as the series does.
class Series {
 public:
  static constexpr std::size_t kMostSpans = 8192;

  /// Requires: `value` is finite, and times do not fall.
  void add(double at_s, double value);
  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
  [[nodiscard]] double first_s() const noexcept { return first_s_; }
  [[nodiscard]] double last_s() const noexcept { return last_s_; }
  [[nodiscard]] const ValueRange& range() const noexcept { return range_; }
  /// Returns the ranges in so many columns from one time to another. A column without a value is
  /// empty.
  [[nodiscard]] std::vector<ValueRange> columns(double from_s, double to_s,
                                                std::size_t count) const;

 private:
  void halve();

  std::uint64_t count_ = 0;
  double first_s_ = 0, last_s_ = 0, span_s_ = 1e-3;
  ValueRange range_;
  std::vector<ValueRange> spans_;  ///< from `first_s_` on
};

}  // namespace galilean::logs
