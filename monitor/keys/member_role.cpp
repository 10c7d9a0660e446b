// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/keys/member_role.h"

#include "core/wire/topic_names.h"

namespace galilean::monitor {
namespace {

constexpr const char* kAnyTopic = "*";

/// It reads its own state, too, to find another robot of its name.
TopicRights robot_rights(const std::string& name) {
  return {
      .writes = {wire::robot_topic(name, "*"), wire::kTeamStopTopic, wire::kTfTopic,
                 wire::kDiagnosticsTopic, wire::kLogTopic},
      .reads = {wire::kProgramPushTopic, wire::kProgramRollbackTopic, wire::kCommandTopic,
                wire::kBreakOrderTopic, wire::kTeamStopTopic, wire::robot_topic(name, "state")}};
}

TopicRights simulator_rights() {
  return {.writes = {wire::kSimulationEventTopic, wire::kSimulationStateTopic, wire::kScoreTopic},
          .reads = {wire::kSimulationOrderTopic}};
}

TopicRights monitor_rights() {
  return {.writes = {wire::kProgramPushTopic, wire::kProgramRollbackTopic, wire::kPushProgressTopic,
                     wire::kCommandTopic, wire::kBreakOrderTopic, wire::kTeamStopTopic,
                     wire::kLeaseChangeTopic, wire::kObjectsTopic, wire::kMapTopic,
                     wire::kMarkersTopic, wire::kTfTopic, wire::kDiagnosticsTopic,
                     wire::kSimulationOrderTopic, "rt/recorder/command", "rt/galilean_doctor_*"},
          .reads = {kAnyTopic}};
}

/// Leaves out orders, and programs that are on their way to robots.
TopicRights viewer_rights() {
  TopicRights rights;
  for (const char* leaf : {"state", "transition", "variables", "forces", "sightings", "program",
                           "catalog", "odom", "breaks", "program_reply", "compressed"})
    rights.reads.push_back(wire::robot_topic("*", leaf));
  for (const char* shared :
       {wire::kObjectsTopic, wire::kMapTopic, wire::kMarkersTopic, wire::kLeaseChangeTopic,
        wire::kPushProgressTopic, wire::kScoreTopic, wire::kSimulationEventTopic,
        wire::kSimulationStateTopic, wire::kTfTopic, wire::kDiagnosticsTopic, wire::kLogTopic})
    rights.reads.emplace_back(shared);
  return rights;
}

}  // namespace

std::string_view name_of(MemberRole role) noexcept {
  switch (role) {
    case MemberRole::kRobot:
      return "robot";
    case MemberRole::kSimulator:
      return "simulator";
    case MemberRole::kMonitor:
      return "monitor";
    case MemberRole::kViewer:
      return "viewer";
    case MemberRole::kRecorder:
      return "recorder";
  }
  return {};
}

std::optional<MemberRole> member_role(std::string_view name) noexcept {
  for (const auto role : kMemberRoles)
    if (name_of(role) == name) return role;
  return {};
}

TopicRights rights_of(MemberRole role, const std::string& name) {
  switch (role) {
    case MemberRole::kRobot:
      return robot_rights(name);
    case MemberRole::kSimulator:
      return simulator_rights();
    case MemberRole::kMonitor:
      return monitor_rights();
    case MemberRole::kViewer:
      return viewer_rights();
    case MemberRole::kRecorder:
      return {.writes = {"rt/recorder/status"}, .reads = {kAnyTopic}};
  }
  return {};
}

}  // namespace galilean::monitor
