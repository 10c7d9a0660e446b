// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace galilean::expect {

/// Whether a condition holds at an instant. The order is that of strength: in an "and" the lowest
/// counts.
enum class Truth : std::uint8_t {
  kFalse,
  kMissing,  ///< what it asks about was not heard, or too long ago
  kVoid,     ///< there is no value: the variable is invalid
  kTrue
};

/// A condition's truth, and its robustness: how far it is from changing, in the unit of its
/// comparison; negative if it is false. What is compared with nothing is infinitely far.
struct Value {
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Truth truth = Truth::kMissing;
  double margin = 0;

  [[nodiscard]] static Value of(bool truth) noexcept {
    return truth ? Value{Truth::kTrue, kFar} : Value{Truth::kFalse, -kFar};
  }
  [[nodiscard]] bool is_true() const noexcept { return truth == Truth::kTrue; }
  [[nodiscard]] bool is_false() const noexcept { return truth == Truth::kFalse; }
  [[nodiscard]] bool is_missing() const noexcept { return truth == Truth::kMissing; }
};

// Kleene's logic with two kinds of unknown, and minimum and maximum of the margins.

[[nodiscard]] inline Value operator!(const Value& value) noexcept {
  if (value.is_true()) return {Truth::kFalse, -value.margin};
  if (value.is_false()) return {Truth::kTrue, -value.margin};
  return value;
}
[[nodiscard]] inline Value both(const Value& a, const Value& b) noexcept {
  return {std::min(a.truth, b.truth), std::min(a.margin, b.margin)};
}
[[nodiscard]] inline Value either(const Value& a, const Value& b) noexcept {
  return !both(!a, !b);
}

}  // namespace galilean::expect
