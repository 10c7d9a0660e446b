// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/seconds_of.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "core/visible_text.h"

namespace galilean {
namespace {

/// Returns how many seconds the unit has; 0 for what is no unit of time.
double seconds_in(std::string_view unit) {
  if (unit == "ms") return 1e-3;
  if (unit.empty() || unit == "s") return 1;
  if (unit == "min") return 60;
  return unit == "h" ? 3600 : 0;
}

}  // namespace

Result<double> seconds_of(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, wrong] = std::from_chars(text.data(), end, number);
  const double unit_s = seconds_in(std::string_view(rest, static_cast<std::size_t>(end - rest)));
  if (wrong != std::errc() || unit_s == 0 || !std::isfinite(number) || number < 0)
    return Error{"'" + visible(text) + "' is not a valid time, such as 10s"};
  return number * unit_s;
}

CommandLineOption add_seconds_option(CommandLine& line, const std::string& names, double& target_s,
                                     const std::string& help) {
  return line.option(
      names,
      [&target_s](const std::string& text) -> Result<void> {
        const auto seconds = seconds_of(text);
        if (!seconds) return seconds.error();
        if (seconds.value() <= 0)
          return Error{"the time must be above 0, and not '" + visible(text) + "'"};
        target_s = seconds.value();
        return {};
      },
      help);
}

}  // namespace galilean
