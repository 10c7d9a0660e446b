// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <string>

#include "core/wire/messages.h"
#include "monitor/top/push/pusher.h"

namespace galilean::monitor::top {

/// Returns what came of a push, in a few words: what the monitor objects to, or the newest that
/// robots say of it, such as "runs, on probation" and "io went back: too slow". `replies` are those
/// to any push, the oldest first.
[[nodiscard]] std::string answer_words(const PushReport& report,
                                       const std::deque<msg::ProgramReply>& replies);

}  // namespace galilean::monitor::top
