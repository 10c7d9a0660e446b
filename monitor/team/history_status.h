// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// The name under which a monitor tells on /diagnostics how its history is.
inline constexpr std::string_view kHistoryStatusName = "galilean-monitor: history";

/// Returns what a monitor tells to be wrong with its history, in one sentence, or an empty text if
/// nothing is; nothing if the message is not about it.
[[nodiscard]] inline std::optional<std::string> history_problem(
    const msg::DiagnosticArray& message) {
  for (const auto& status : message.status)
    if (status.name == kHistoryStatusName) return status.level == 0 ? "" : status.message;
  return std::nullopt;
}

}  // namespace galilean::monitor
