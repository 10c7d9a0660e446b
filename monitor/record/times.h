// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace galilean::monitor {

/// Returns a time in UTC as ISO 8601 text, such as "2026-11-22T01:04:33.250Z".
[[nodiscard]] std::string iso_time(std::uint64_t since_epoch_ns);
/// Returns a length of time in its fitting unit: "5.9 s", "12.0 min", "3.5 h", "4.0 days" or
/// "56.9 years".
[[nodiscard]] std::string time_span(double span_s);

}  // namespace galilean::monitor
