// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/clock.h"
#include "core/result.h"
#include "monitor/commands/monitor_client.h"
#include "monitor/commands/push_options.h"

namespace galilean::monitor {

/// Returns the body of POST /api/push, with a new id: if its answer is lost, the same may be sent
/// again, and is one push.
[[nodiscard]] nlohmann::json push_request(const std::vector<bhdl::SourceFile>& files,
                                          const PushOptions& options);

/// Sends a request that may be sent twice, such as that of a push, until it is answered. A first
/// one that cannot be sent is not repeated. `pause` waits before each repetition, and returns false
/// to give up. Errors: the request cannot be sent, or nobody has answered it; if `was_sent`, the
/// monitor may have done what it asks for.
[[nodiscard]] Result<MonitorAnswer, Unanswered> ask_until_answered(
    const std::function<Result<MonitorAnswer, Unanswered>()>& ask,
    const std::function<bool()>& pause, bool was_sent = false);
/// How long a command asks again for an answer that was lost. A monitor starts again in less.
inline constexpr Duration kAskAgainFor = std::chrono::seconds(15);

/// Pushes a program through a monitor. Prints each step as it happens, and each robot's answer.
/// Ctrl-C cancels the push as far as it has not begun. `command` is the command's name in messages.
/// Returns the process' exit code.
[[nodiscard]] int push_through(const MonitorClient& monitor, const std::string& command,
                               const std::vector<bhdl::SourceFile>& files,
                               const PushOptions& options);

/// Prints one robot's answer in a line, and its diagnostics below.
void print_reply(const nlohmann::json& reply);

}  // namespace galilean::monitor
