// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/variable_text.h"

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "core/geometry.h"

namespace galilean::monitor::top {
namespace {

[[gnu::format(printf, 1, 2)]] std::string print(const char* format, ...) {
  std::array<char, 80> text{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text.data(), text.size(), format, arguments);
  va_end(arguments);
  return text.data();
}

/// Returns 0 for numbers that would print as "-0.00".
double tidy(double number) {
  constexpr double kShownAsZero = 0.005;
  return std::abs(number) < kShownAsZero ? 0 : number;
}

/// Returns the bits with bit 0 first, as programs count them: "·1··" has bit 1 set. There are at
/// least eight.
std::string bits_text(double value) {
  const auto bits = value >= 0 && value < 4294967296.0 ? static_cast<std::uint32_t>(value) : 0U;
  std::string text;
  for (unsigned index = 0; index < 8 || bits >> index > 0; ++index) {
    text += (bits >> index) & 1U ? "1" : "·";
    if (index == 31) break;
  }
  return text;
}

std::string locate_text(const std::vector<double>& v) {
  const double deviation_m = std::sqrt(std::max(0.0, (v[2] + v[4]) / 2));
  return print("%.2f, %.2f ±%.2f m", tidy(v[0]), tidy(v[1]), deviation_m);
}

}  // namespace

std::string variable_text(const msg::Variable& variable) {
  namespace types = msg::Variable_Constants;
  const auto& v = variable.values;
  if (!variable.valid) return "-";
  if (variable.type == types::SHAFT && v.size() >= 3)
    return print("%.2f, %.2f m %.0f°", tidy(v[0]), tidy(v[1]), v[2] * 180 / kPi);
  if (variable.type == types::IMAGE && v.size() >= 3) return print("frame %.0f", v[2]);
  if (variable.type == types::LOCATE && v.size() >= 5) return locate_text(v);
  if (variable.type == types::BITS && !v.empty()) return bits_text(v[0]);
  if (variable.type == types::FORCE && v.size() >= 2)
    return print("%.2f, %.2f", tidy(v[0]), tidy(v[1]));
  return "-";
}

}  // namespace galilean::monitor::top
