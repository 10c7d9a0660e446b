// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/duration_text.h"

#include <cstdio>

namespace galilean::expect {

std::string duration_text(std::int64_t duration_ns) {
  char text[48];
  std::snprintf(text, sizeof text, "%.3f", static_cast<double>(duration_ns) * 1e-9);
  std::string digits = text;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.ends_with('.')) digits.pop_back();
  return digits + " s";
}

std::string short_number(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number == 0 ? 0 : number);  // -0 is 0 to people
  return text;
}

}  // namespace galilean::expect
