// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace galilean::monitor {

/// "2026-11-22T01:04:33.250Z" for nanoseconds since the Unix epoch.
[[nodiscard]] std::string iso_time(std::int64_t since_epoch_ns);

}  // namespace galilean::monitor
