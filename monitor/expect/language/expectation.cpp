// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/expectation.h"

#include <array>
#include <cmath>

namespace galilean::expect {

std::string to_string(Operator op) {
  constexpr std::array<const char*, 6> kTexts{"=", "!=", "<", "<=", ">", ">="};
  return kTexts.at(static_cast<std::size_t>(op));
}

bool holds(double value, Operator op, double limit) noexcept {
  switch (op) {
    case Operator::kEqual:
      return value == limit;
    case Operator::kUnequal:
      return value != limit;
    case Operator::kLess:
      return value < limit;
    case Operator::kAtMost:
      return value <= limit;
    case Operator::kGreater:
      return value > limit;
    case Operator::kAtLeast:
      break;
  }
  return value >= limit;
}

double margin(double value, Operator op, double limit) noexcept {
  switch (op) {
    case Operator::kEqual:
      return -std::abs(value - limit);
    case Operator::kUnequal:
      return std::abs(value - limit);
    case Operator::kLess:
    case Operator::kAtMost:
      return limit - value;
    case Operator::kGreater:
    case Operator::kAtLeast:
      break;
  }
  return value - limit;
}

std::string TopicName::of(const std::string& robot) const {
  return relative() ? "/" + robot + text.substr(1) : text;
}

}  // namespace galilean::expect
