// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/wire/messages.h"
#include "robot/executive/break_point.h"

namespace galilean::robot {

/// Returns what a kind is called on the wire: "stop", "stop_team" or "lock".
[[nodiscard]] std::string_view to_string(BreakKind kind) noexcept;
/// Returns nothing if no kind is called so.
[[nodiscard]] std::optional<BreakKind> break_kind_named(std::string_view name) noexcept;

/// Returns "break point wander -> grab".
[[nodiscard]] std::string name_of(const BreakPoint& point);
/// Returns what an order says, such as "Anna sets break points: wander -> grab (stop)".
[[nodiscard]] std::string in_words(const msg::BreakOrder& order);

}  // namespace galilean::robot
