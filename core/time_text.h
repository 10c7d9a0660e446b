// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace galilean {

/// Returns a time as people and sort(1) read it: 2026-03-01T12:00:00Z. A year of more digits than
/// C's time has is told as the number of seconds.
[[nodiscard]] std::string utc_text(std::int64_t since_1970_s);

/// Returns a time on this machine's clock: 2026-03-01 13:00:00.
[[nodiscard]] std::string local_time(std::int64_t since_1970_ns);

}  // namespace galilean
