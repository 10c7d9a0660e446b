// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/times.h"

#include <array>
#include <cstdio>
#include <ctime>

namespace galilean::monitor {

std::string iso_time(std::int64_t since_epoch_ns) {
  const std::time_t seconds = since_epoch_ns / 1'000'000'000;
  const auto milliseconds = static_cast<int>(since_epoch_ns / 1'000'000 % 1000);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::array<char, 40> date{}, text{};
  std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &utc);
  std::snprintf(text.data(), text.size(), "%.24s.%03dZ", date.data(), milliseconds);
  return text.data();
}

}  // namespace galilean::monitor
