// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bhdl/program/program.h"
#include "monitor/commands/monitor_client.h"
#include "monitor/commands/push_options.h"

namespace galilean::monitor {

/// Returns the body of POST /api/push.
[[nodiscard]] nlohmann::json push_request(const std::vector<bhdl::SourceFile>& files,
                                          const PushOptions& options);

/// Pushes a program through a monitor. Prints each step as it happens, and each robot's answer.
/// Ctrl-C cancels the push as far as it has not begun. `command` is the command's name in messages.
/// Returns the process' exit code.
[[nodiscard]] int push_through(const MonitorClient& monitor, const std::string& command,
                               const std::vector<bhdl::SourceFile>& files,
                               const PushOptions& options);

/// Prints one robot's answer in a line, and its diagnostics below.
void print_reply(const nlohmann::json& reply);

}  // namespace galilean::monitor
