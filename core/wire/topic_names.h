// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::wire {

/// Returns the DDS name of a robot's topic: "rt/io/state" for ("io", "state"), as ROS 2 names its
/// topic /io/state on DDS.
[[nodiscard]] std::string robot_topic(std::string_view robot, std::string_view leaf);
inline constexpr const char* kProgramPushTopic = "rt/team/program_push";
inline constexpr const char* kProgramRollbackTopic = "rt/team/program_rollback";
inline constexpr const char* kPushProgressTopic = "rt/team/push_progress";
inline constexpr const char* kCommandTopic = "rt/team/command";
inline constexpr const char* kBreakOrderTopic = "rt/team/break_order";
inline constexpr const char* kLeaseChangeTopic = "rt/team/lease_change";
inline constexpr const char* kTeamStopTopic = "rt/team/team_stop";
inline constexpr const char* kObjectsTopic = "rt/team/objects";
inline constexpr const char* kMapTopic = "rt/team/map";
inline constexpr const char* kMarkersTopic = "rt/team/markers";
inline constexpr const char* kScoreTopic = "rt/referee/score";
inline constexpr const char* kSimulationOrderTopic = "rt/simulation/order";
inline constexpr const char* kSimulationEventTopic = "rt/simulation/event";
inline constexpr const char* kSimulationStateTopic = "rt/simulation/state";
inline constexpr const char* kTfTopic = "rt/tf";
inline constexpr const char* kDiagnosticsTopic = "rt/diagnostics";
inline constexpr const char* kLogTopic = "rt/rosout";
inline constexpr const char* kClockTopic = "rt/clock";

}  // namespace galilean::wire
