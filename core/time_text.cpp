// SPDX-License-Identifier: BSD-3-Clause
#include "core/time_text.h"

#include <array>
#include <ctime>

namespace galilean {

std::string utc_text(std::int64_t since_1970_s) {
  const auto time = static_cast<std::time_t>(since_1970_s);
  std::tm parts{};
  std::array<char, 64> text{};
  if (gmtime_r(&time, &parts) == nullptr) return std::to_string(since_1970_s);
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

std::string local_time(std::int64_t since_1970_ns) {
  const auto time = static_cast<std::time_t>(since_1970_ns / 1'000'000'000);
  std::tm parts{};
  std::array<char, 64> text{};
  localtime_r(&time, &parts);
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &parts)};
}

}  // namespace galilean
