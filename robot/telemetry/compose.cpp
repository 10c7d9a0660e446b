// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/compose.h"

#include <array>
#include <cmath>

namespace galilean::robot {
namespace {

struct WireType {
  std::string_view name;
  std::uint8_t number;
  std::size_t values;
};
constexpr std::array<WireType, 5> kWireTypes{{
    {variable_type_name<Shaft>(), msg::Variable_Constants::SHAFT, 5},
    {variable_type_name<Image>(), msg::Variable_Constants::IMAGE, 3},
    {variable_type_name<Locate>(), msg::Variable_Constants::LOCATE, 6},
    {variable_type_name<Bits>(), msg::Variable_Constants::BITS, 1},
    {variable_type_name<Force>(), msg::Variable_Constants::FORCE, 2},
}};

const WireType& wire_type(std::string_view name) {
  for (const auto& type : kWireTypes)
    if (type.name == name) return type;
  return kWireTypes.front();
}

float microseconds(Duration duration) noexcept {
  return static_cast<float>(to_seconds(duration) * 1e6);
}

msg::Quaternion quaternion(double heading_rad) noexcept {
  msg::Quaternion turn;
  turn.z = std::sin(heading_rad / 2);
  turn.w = std::cos(heading_rad / 2);
  return turn;
}

void fill(const Sighting& from, msg::Sighting& to) noexcept {
  to.x_m = from.position_m.x();
  to.y_m = from.position_m.y();
  to.variance_xx = from.covariance_m2(0, 0);
  to.variance_xy = from.covariance_m2(0, 1);
  to.variance_yy = from.covariance_m2(1, 1);
  to.range_m = static_cast<float>(from.range_m);
  to.azimuth_rad = static_cast<float>(from.azimuth_rad);
  to.left_px = from.left_px;
  to.top_px = from.top_px;
  to.right_px = from.right_px;
  to.bottom_px = from.bottom_px;
  to.area_px = from.area_px;
}

std::vector<msg::TestedCondition> tested_conditions(const bhdl::State& state,
                                                    const ConditionSnapshot& tested) {
  std::vector<msg::TestedCondition> list;
  for (std::size_t i = 0; i < state.conditions.size() && i < ConditionSnapshot::kMost; ++i) {
    const bhdl::Condition& condition = state.conditions[i];
    msg::TestedCondition& item = list.emplace_back();
    item.to_state = condition.new_state;
    item.file = condition.location.file;
    item.line = static_cast<std::uint32_t>(condition.location.line);
    item.bits_variable = condition.bits_variable;
    item.bit_index = condition.bit_index;
    item.bit_value = condition.bit_value;
    item.valid = (tested.valid >> i & 1U) != 0;
    item.holds = (tested.holds >> i & 1U) != 0;
  }
  return list;
}

}  // namespace

msg::Header Composer::header(Time time, const std::string& frame) const {
  msg::Header header;
  header.stamp = wall_.stamp(time);
  header.frame_id = frame;
  return header;
}

msg::RobotState Composer::state(const Snapshot& snapshot, const Description* program,
                                const std::vector<Problem>& problems) const {
  msg::RobotState state;
  state.stamp = wall_.stamp(snapshot.now);
  state.robot = robot_;
  if (program) {
    state.program_name = program->program.name;
    state.program_hash = program->program.hash;
    state.state = program->program.states.at(snapshot.state).name;
  }
  state.state_since = wall_.stamp(snapshot.state_since);
  state.tick = snapshot.tick;
  state.transitions = snapshot.transitions;
  state.tick_period_s = static_cast<float>(to_seconds(snapshot.tick_period));
  state.tick_time_us = microseconds(snapshot.tick_time);
  state.tick_time_max_us = microseconds(snapshot.longest_tick_time);
  state.overruns = snapshot.overruns;
  state.held = !lets_drive(snapshot.standstill.hold);
  state.out_of_service = snapshot.out_of_service;
  state.in_probation = snapshot.in_probation;
  state.x_m = snapshot.pose.position_m.x();
  state.y_m = snapshot.pose.position_m.y();
  state.heading_rad = snapshot.pose.heading_rad;
  for (const Problem& problem : problems) state.problems.push_back(problem.text());
  return state;
}

msg::Variables Composer::variables(const Snapshot& snapshot, const Description& program) const {
  msg::Variables variables;
  variables.stamp = wall_.stamp(snapshot.now);
  variables.robot = robot_;
  variables.tick = snapshot.tick;
  for (std::size_t i = 0; i < snapshot.variables.size(); ++i) {
    const auto& sample = snapshot.variables[i];
    const auto& label = program.variables.at(i);
    const WireType& type = wire_type(label.type);
    msg::Variable& item = variables.items.emplace_back();
    item.name = label.name;
    item.type = type.number;
    if (type.number == msg::Variable_Constants::LOCATE)
      item.object_class = to_string(sample.object);
    item.valid = sample.valid;
    item.certainty = static_cast<float>(sample.certainty);
    item.decay_per_s = static_cast<float>(sample.decay_per_s);
    item.updated = wall_.stamp(sample.updated);
    item.values.assign(sample.values.begin(), sample.values.begin() + type.values);
  }
  return variables;
}

msg::Forces Composer::forces(const Snapshot& snapshot, const Description& program) const {
  msg::Forces forces;
  forces.stamp = wall_.stamp(snapshot.now);
  forces.robot = robot_;
  forces.tick = snapshot.tick;
  for (std::size_t i = 0; i < snapshot.forces.size(); ++i) {
    const auto& label = program.forces.at(i);
    msg::SchemaForce& item = forces.items.emplace_back();
    item.schema = label.schema;
    item.variable = label.variable;
    item.x = static_cast<float>(snapshot.forces[i].force.x());
    item.y = static_cast<float>(snapshot.forces[i].force.y());
    item.gain = static_cast<float>(label.gain);
    item.active = snapshot.forces[i].active;
  }
  return forces;
}

msg::Sightings Composer::sightings(const Snapshot& snapshot, const Description& program) const {
  msg::Sightings sightings;
  sightings.stamp = wall_.stamp(snapshot.frame_captured);
  sightings.robot = robot_;
  sightings.x_m = snapshot.pose.position_m.x();
  sightings.y_m = snapshot.pose.position_m.y();
  sightings.heading_rad = snapshot.pose.heading_rad;
  sightings.view_angle_rad = static_cast<float>(snapshot.view_angle_rad);
  for (const auto& sample : snapshot.sightings) {
    msg::Sighting& item = sightings.items.emplace_back();
    item.object_class = to_string(sample.object);
    item.variable = program.variables.at(sample.variable).name;
    fill(sample.sighting, item);
  }
  return sightings;
}

msg::Odometry Composer::odometry(const Snapshot& snapshot) const {
  msg::Odometry odometry;
  odometry.header = header(snapshot.now, robot_ + "/odom");
  odometry.child_frame_id = robot_ + "/base_link";
  odometry.pose.pose.position.x = snapshot.pose.position_m.x();
  odometry.pose.pose.position.y = snapshot.pose.position_m.y();
  odometry.pose.pose.orientation = quaternion(snapshot.pose.heading_rad);
  odometry.twist.twist.linear.x = snapshot.speed_mps;
  odometry.twist.twist.angular.z = snapshot.turn_rate_radps;
  return odometry;
}

msg::TFMessage Composer::transform(const Snapshot& snapshot) const {
  msg::TFMessage message;
  msg::TransformStamped& transform = message.transforms.emplace_back();
  transform.header = header(snapshot.now, robot_ + "/odom");
  transform.child_frame_id = robot_ + "/base_link";
  transform.transform.translation.x = snapshot.pose.position_m.x();
  transform.transform.translation.y = snapshot.pose.position_m.y();
  transform.transform.rotation = quaternion(snapshot.pose.heading_rad);
  return message;
}

msg::DiagnosticArray Composer::diagnostics(const Snapshot& snapshot,
                                           const std::vector<Problem>& problems) const {
  constexpr std::uint8_t kOk = 0;
  constexpr std::uint8_t kError = 2;
  msg::DiagnosticArray array;
  array.header = header(snapshot.now, "");
  msg::DiagnosticStatus& ticks = array.status.emplace_back();
  ticks.level = snapshot.program ? kOk : kError;
  ticks.name = robot_ + "/executive";
  ticks.message = snapshot.program ? "running" : "no program runs";
  ticks.hardware_id = robot_;
  ticks.values = {{"tick_us", std::to_string(microseconds(snapshot.tick_time))},
                  {"longest_tick_us", std::to_string(microseconds(snapshot.longest_tick_time))},
                  {"overruns", std::to_string(snapshot.overruns)}};
  for (const Problem& problem : problems) {
    msg::DiagnosticStatus& status = array.status.emplace_back();
    status.level = kError;
    status.name = robot_ + "/" + problem.subject;
    status.message = problem.sentence;
    status.hardware_id = robot_;
  }
  return array;
}

msg::Transition Composer::transition(const Event& event, const Description& from,
                                     const Description& to) const {
  msg::Transition transition;
  transition.stamp = wall_.stamp(event.time);
  transition.robot = robot_;
  transition.number = event.number;
  transition.tick = event.tick;
  const auto& state = from.program.states.at(event.from_state);
  transition.from_state = state.name;
  transition.to_state = to.program.states.at(event.to_state).name;
  transition.cause = cause_of(event, from);
  transition.program_hash = to.program.hash;
  if (event.cause != Event::Cause::kCondition) return transition;
  const auto& condition = state.conditions.at(event.condition);
  transition.file = condition.location.file;
  transition.line = static_cast<std::uint32_t>(condition.location.line);
  transition.bits_variable = condition.bits_variable;
  transition.bit_index = condition.bit_index;
  transition.bit_value = condition.bit_value;
  transition.reset_variables = condition.reset_variables;
  transition.tested = tested_conditions(state, event.tested);
  return transition;
}

}  // namespace galilean::robot
