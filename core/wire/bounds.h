// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/wire/cdr_checker.h"

namespace galilean::wire {

/// Walks through a message of one type, as the type's bounds in idl/*.bounds say.
using Bounds = void (*)(msg::CdrChecker& message);

/// Returns the bounds of a message type; nullptr if no message has that name.
[[nodiscard]] Bounds bounds_of(std::string_view ros_type) noexcept;

/// Returns what is wrong with a message; empty: it is whole and each field is within its bounds.
/// The text is one of a fixed number, and lives as long as the program.
[[nodiscard]] inline std::string_view fault_of(Bounds bounds, std::span<const std::uint8_t> cdr) {
  msg::CdrChecker checker(cdr);
  bounds(checker);
  return checker.fault();
}

}  // namespace galilean::wire
