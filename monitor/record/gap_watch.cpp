// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/gap_watch.h"

#include "core/wire/messages.h"
#include "core/wire/schemas.h"

namespace galilean::monitor {
namespace {

bool has_type(const wire::EndpointInfo& writer, const char* ros_type) {
  const auto* schema = wire::find_schema_by_ros_type(ros_type);
  return schema && writer.dds_type == schema->dds_type;
}

/// Returns "rt/io" of "rt/io/state".
std::string_view without_leaf(std::string_view topic) {
  return topic.substr(0, topic.rfind('/'));
}

}  // namespace

bool is_robot_event(const wire::EndpointInfo& writer) {
  return (writer.topic.ends_with("/transition") && has_type(writer, msg::Transition::kRosType)) ||
         (writer.topic.ends_with("/program_reply") &&
          has_type(writer, msg::ProgramReply::kRosType));
}

bool GapWatch::is_state(const wire::EndpointInfo& writer) {
  return writer.topic.ends_with("/state") && has_type(writer, msg::RobotState::kRosType);
}

wire::EndpointInfo GapWatch::transitions_of(wire::EndpointInfo state) {
  state.topic = std::string(without_leaf(state.topic)) + "/transition";
  state.dds_type = wire::find_schema_by_ros_type(msg::Transition::kRosType)->dds_type;
  return state;
}

bool GapWatch::note(const wire::EndpointInfo& writer, const wire::Received& received, Time now) {
  const bool is_of_state = is_state(writer);
  if (!is_of_state && !is_robot_event(writer)) return false;
  const auto robot = without_leaf(writer.topic);
  auto known = robots_.find(robot);
  if (known == robots_.end()) {
    if (robots_.size() >= kMostRobots) robots_.clear();
    known = robots_.emplace(std::string(robot), wire::CutOffWatch()).first;
  }
  if (!is_of_state) return known->second.fills_gap(now, received.sent_ns);
  known->second.note_state(now, received.sent_ns);
  return false;
}

}  // namespace galilean::monitor
