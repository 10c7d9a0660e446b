// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bhdl/program/program.h"
#include "monitor/commands/monitor_client.h"
#include "monitor/commands/push_options.h"

namespace galilean::monitor {

/// Exit codes of commands that push.
inline constexpr int kPushRefused = 1;
inline constexpr int kCannotReach = 2;

/// Pushes a program through a monitor and prints each step as it happens, and each robot's answer.
/// Ctrl-C cancels what has not begun. Returns the exit code; `command` names it in messages.
[[nodiscard]] int push_through(const MonitorClient& monitor, const std::string& command,
                               const std::vector<bhdl::SourceFile>& files,
                               const PushOptions& options);

/// One robot's answer in a line, with what it objects to below.
void print_reply(const nlohmann::json& reply);

}  // namespace galilean::monitor
