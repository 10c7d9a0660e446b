// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/wire/messages.h"
#include "monitor/top/model/view.h"

namespace galilean::monitor::top {

// A robot that has told nothing about break points has no marks.

/// Returns what the break points do that stop whoever enters the state, from wherever.
[[nodiscard]] BreakMark mark_on_entering(const std::optional<msg::Breaks>& breaks,
                                         std::string_view state);
/// Returns what the break points do that name `from`, and `to` or no state that is entered.
[[nodiscard]] BreakMark mark_at(const std::optional<msg::Breaks>& breaks, std::string_view from,
                                std::string_view to);
/// Returns what a kind of msg::BreakPoint_Constants does; kNone if this release does not know it.
[[nodiscard]] BreakMark mark_of(std::uint8_t kind) noexcept;

}  // namespace galilean::monitor::top
