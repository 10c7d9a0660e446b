// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wire/messages.h"

namespace galilean {

// Which orders make robots stand still, or keep them so, and do nothing else: they need neither a
// signature nor a lease, because whoever sees a robot go wrong must be able to stop it. An order
// that this release does not know is none of them.

/// Holding a robot and taking it out of service stop it.
[[nodiscard]] bool only_stops(const msg::Command& command) noexcept;
/// A new break point stops a robot. A lock does not: the robot drives on in its state, and may take
/// another way out of it.
[[nodiscard]] bool only_stops(const msg::BreakOrder& order) noexcept;

}  // namespace galilean
