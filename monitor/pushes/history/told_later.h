// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "monitor/pushes/history/push_record.h"

namespace galilean::monitor {

// A push may end before its robots have told what became of it: its monitor ended, or the network
// was cut. What they tell later is then its end.

/// Returns whether the push ended although all its robots had been sent the program and each of
/// them may run it: its monitor ended, or the last step failed.
[[nodiscard]] bool may_be_told_later(const PushRecord& push);
/// Returns the progress of a push of which all robots have told now that they run the program;
/// nothing if it ended otherwise, or a robot has not told so.
[[nodiscard]] std::optional<Progress> told_later(const PushRecord& push, std::int64_t now_ns);

/// Returns whether a robot that replied so may still tell what became of a push: it did not answer,
/// or it ran the program and might have gone back.
[[nodiscard]] bool is_undecided(ReplyStatus status);
/// Returns the replies of the robots of which it is not known what became of a push that is over;
/// none of a push that was made without this monitor.
[[nodiscard]] std::vector<RobotReply> undecided(const PushRecord& push);

/// Returns what is known of a robot once `reply` has come late; nothing if it tells nothing new.
[[nodiscard]] std::optional<RobotReply> with_late_reply(const PushRecord& push,
                                                        const msg::ProgramReply& reply);

}  // namespace galilean::monitor
