// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/wire/messages.h"
#include "core/wire/ros_time.h"

namespace galilean::monitor {

/// The names under which a monitor tells on /diagnostics how its history and its map are.
inline constexpr std::string_view kHistoryStatusName = "galilean-monitor: history";
inline constexpr std::string_view kMapStatusName = "galilean-monitor: map";

/// Returns what a monitor tells on /diagnostics under `name`. `problem` is what is wrong, in one
/// sentence; where it is empty, `well` is told.
[[nodiscard]] inline msg::DiagnosticArray monitor_status(std::string_view name,
                                                         const std::string& problem,
                                                         const std::string& well) {
  constexpr std::uint8_t kGoodLevel = 0, kErrorLevel = 2;
  msg::DiagnosticArray message;
  message.header.stamp = wire::ros_time(wire::wall_clock_ns());
  auto& status = message.status.emplace_back();
  status.level = problem.empty() ? kGoodLevel : kErrorLevel;
  status.name = name;
  status.message = problem.empty() ? well : problem;
  status.hardware_id = "galilean-monitor";
  return message;
}

/// Returns what a monitor tells under `name` to be wrong, in one sentence, or an empty text if
/// nothing is; nothing if the message is not about it.
[[nodiscard]] inline std::optional<std::string> monitor_problem(const msg::DiagnosticArray& message,
                                                                std::string_view name) {
  for (const auto& status : message.status)
    if (status.name == name) return status.level == 0 ? "" : status.message;
  return std::nullopt;
}

}  // namespace galilean::monitor
