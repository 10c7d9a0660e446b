// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/gains/range.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bhdl/source/text.h"
#include "monitor/top/gains/tunables.h"

namespace galilean::monitor::top {
namespace {

constexpr double kSame = 1e-9;  ///< what two numbers that are meant to be one may differ by

/// Returns the next of 1, 2, 5, 10, 20, 50 … that is no less.
double rounded_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(std::max(value, kSame))));
  for (const double round : {1.0, 2.0, 5.0})
    if (round * power >= value * (1 - kSame)) return round * power;
  return 10 * power;
}

/// Returns a decimal number without the zeros at its end.
std::string without_zeros(std::string text) {
  if (text.find('.') == text.npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string with_digits(double value, int digits) {
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return without_zeros(text);
}

}  // namespace

Range range_of(double value, std::string_view unit, const AttributeSpec& spec) {
  constexpr double kMostSteps = 200, kLarge = 300, kTimes = 3;
  const bool is_whole = spec.type == AttributeType::kInteger;
  const bool has_limits = unit.empty() || unit == spec.unit.symbol;
  const double far = std::max(rounded_up(std::abs(value) * kTimes), is_whole ? 10.0 : 1.0);
  const double least = has_limits && std::isfinite(spec.minimum) ? spec.minimum : 0;
  const double most = has_limits && std::isfinite(spec.maximum) ? spec.maximum : far;
  Range range;
  range.max = std::max(most <= kLarge ? most : std::min(most, far), value);
  range.min = std::min(least, value);
  range.step = is_whole ? 1 : rounded_up((range.max - range.min) / kMostSteps);
  return range;
}

std::string number_text(double value, double step) {
  return with_digits(value, std::max(0, static_cast<int>(std::ceil(-std::log10(step) - kSame))));
}

std::string exact_text(double value) {
  constexpr int kAllDigits = 20;
  const std::string text = bhdl::number_text(value);
  return text.find('e') == text.npos ? text : with_digits(value, kAllDigits);
}

}  // namespace galilean::monitor::top
