// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/wire/messages.h"

namespace galilean::wire {

/// These convert between nanoseconds since the Unix epoch and the message form. wall_clock_ns
/// returns the present time in the same unit. It is for stamps only.
[[nodiscard]] msg::Time ros_time(std::int64_t since_epoch_ns) noexcept;
[[nodiscard]] std::int64_t since_epoch_ns(const msg::Time& time) noexcept;
[[nodiscard]] std::int64_t wall_clock_ns() noexcept;

}  // namespace galilean::wire
