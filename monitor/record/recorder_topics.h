// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean::monitor {

/// The topics on which recorders take galilean_msgs/Command, of which HOLD pauses and RESUME
/// resumes, and tell how they are, as diagnostic_msgs/DiagnosticArray. They are not recorded.
inline constexpr const char* kRecorderCommandTopic = "rt/recorder/command";
inline constexpr const char* kRecorderStatusTopic = "rt/recorder/status";

}  // namespace galilean::monitor
