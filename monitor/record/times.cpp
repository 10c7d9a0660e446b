// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/times.h"

#include <array>
#include <cstdio>
#include <ctime>

namespace galilean::monitor {

std::string iso_time(std::uint64_t since_epoch_ns) {
  const auto seconds = static_cast<std::time_t>(since_epoch_ns / 1'000'000'000);
  const auto milliseconds = static_cast<int>(since_epoch_ns / 1'000'000 % 1000);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::array<char, 40> date{}, text{};
  std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &utc);
  std::snprintf(text.data(), text.size(), "%.24s.%03dZ", date.data(), milliseconds);
  return text.data();
}

std::string time_span(double span_s) {
  struct Unit {
    double seconds;
    const char* name;
  };
  constexpr std::array<Unit, 5> kUnits{
      {{365.25 * 86400, "years"}, {86400, "days"}, {3600, "h"}, {60, "min"}, {1, "s"}}};
  const auto* unit = &kUnits.front();
  while (unit != &kUnits.back() && span_s < 2 * unit->seconds) ++unit;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.1f %s", span_s / unit->seconds, unit->name);
  return text.data();
}

}  // namespace galilean::monitor
