// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace galilean::monitor {

/// What a member of a secured team is for, which decides what it may write and read.
enum class MemberRole { kRobot, kSimulator, kMonitor, kViewer, kRecorder };

inline constexpr std::array kMemberRoles{MemberRole::kRobot, MemberRole::kSimulator,
                                         MemberRole::kMonitor, MemberRole::kViewer,
                                         MemberRole::kRecorder};

/// Returns "robot", "simulator", "monitor", "viewer" or "recorder".
[[nodiscard]] std::string_view name_of(MemberRole role) noexcept;
/// Returns the role of that name, or nothing if there is none.
[[nodiscard]] std::optional<MemberRole> member_role(std::string_view name) noexcept;

/// Topics as DDS names them, in which * stands for any characters, also a slash.
struct TopicRights {
  std::vector<std::string> writes, reads;
};

/// Returns what a member may do. A robot writes topics of its own name alone, and what all robots
/// share. A monitor also stands for people who steer without one, as `galilean stop` does.
[[nodiscard]] TopicRights rights_of(MemberRole role, const std::string& name);

}  // namespace galilean::monitor
