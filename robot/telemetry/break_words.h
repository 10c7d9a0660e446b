// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/wire/messages.h"
#include "robot/executive/break_point.h"

namespace galilean::robot {

/// Returns the kind as a value of msg::BreakPoint_Constants.
[[nodiscard]] std::uint8_t on_wire(BreakKind kind) noexcept;
/// Returns the kind of a value of msg::BreakPoint_Constants, or nothing if it is none of them.
[[nodiscard]] std::optional<BreakKind> break_kind_of(std::uint8_t value) noexcept;

[[nodiscard]] msg::BreakPoint on_wire(const BreakPoint& point);

/// Returns "break point wander -> grab".
[[nodiscard]] std::string name_of(const BreakPoint& point);
/// Returns "io's break point wander -> grab, set by Anna".
[[nodiscard]] std::string in_words(const msg::TeamStop& stop);
/// Returns what an order says, such as "Anna sets break points: wander -> grab (stop)".
[[nodiscard]] std::string in_words(const msg::BreakOrder& order);

}  // namespace galilean::robot
