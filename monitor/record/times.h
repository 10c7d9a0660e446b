// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace galilean::monitor {

/// Returns a time in UTC as ISO 8601 text, such as "2026-11-22T01:04:33.250Z".
[[nodiscard]] std::string iso_time(std::int64_t since_epoch_ns);

}  // namespace galilean::monitor
