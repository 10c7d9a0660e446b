// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/wire/messages.h"

namespace galilean::wire {

/// Nanoseconds since the Unix epoch, in the message form; and now, for stamps alone.
[[nodiscard]] msg::Time ros_time(std::int64_t since_epoch_ns) noexcept;
[[nodiscard]] std::int64_t since_epoch_ns(const msg::Time& time) noexcept;
[[nodiscard]] std::int64_t wall_clock_ns() noexcept;

}  // namespace galilean::wire
