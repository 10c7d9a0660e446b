// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/wire/messages.h"

namespace galilean::expect {

/// Writes plain CDR, little-endian, for recordings that tests make.
class CdrText {
 public:
  template <class Number>
  requires std::is_arithmetic_v<Number> CdrText& add(Number number) {
    const std::size_t content = bytes_.size() - 4;
    bytes_.resize(4 + (content + sizeof number - 1) / sizeof number * sizeof number);
    const auto at = bytes_.size();
    bytes_.resize(at + sizeof number);
    std::memcpy(bytes_.data() + at, &number, sizeof number);
    return *this;
  }
  CdrText& add(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
    return *this;
  }
  CdrText& add(const msg::Time& time) { return add(time.sec).add(time.nanosec); }
  CdrText& add(const std::vector<std::string>& texts) {
    add(static_cast<std::uint32_t>(texts.size()));
    for (const auto& text : texts) add(text);
    return *this;
  }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const noexcept { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_{0, 1, 0, 0};
};

/// Each returns the message as it is on the wire.
[[nodiscard]] inline std::vector<std::uint8_t> cdr(const msg::RobotState& state) {
  CdrText text;
  text.add(state.stamp).add(state.robot).add(state.program_name).add(state.program_hash);
  text.add(state.state).add(state.state_since).add(state.tick).add(state.transitions);
  text.add(state.tick_period_s).add(state.tick_time_us).add(state.tick_time_max_us);
  text.add(state.overruns).add(state.held).add(state.in_probation).add(state.out_of_service);
  text.add(state.x_m).add(state.y_m).add(state.heading_rad);
  text.add(static_cast<std::uint32_t>(state.problems.size()));
  for (const auto& problem : state.problems) text.add(problem);
  return text.bytes();
}
[[nodiscard]] inline std::vector<std::uint8_t> cdr(const msg::Variables& variables) {
  CdrText text;
  text.add(variables.stamp).add(variables.robot).add(variables.tick);
  text.add(static_cast<std::uint32_t>(variables.items.size()));
  for (const auto& item : variables.items) {
    text.add(item.name).add(item.type).add(item.object_class).add(item.valid);
    text.add(item.certainty).add(item.decay_per_s).add(item.updated);
    text.add(static_cast<std::uint32_t>(item.values.size()));
    for (const double value : item.values) text.add(value);
  }
  return text.bytes();
}

[[nodiscard]] inline std::vector<std::uint8_t> cdr(const msg::Transition& transition) {
  CdrText text;
  text.add(transition.stamp).add(transition.robot).add(transition.number).add(transition.tick);
  text.add(transition.from_state).add(transition.to_state).add(transition.cause);
  text.add(transition.program_hash).add(transition.file).add(transition.line);
  text.add(transition.bits_variable).add(transition.bit_index).add(transition.bit_value);
  text.add(transition.reset_variables);
  text.add(static_cast<std::uint32_t>(transition.tested.size()));
  for (const auto& tested : transition.tested) {
    text.add(tested.to_state).add(tested.file).add(tested.line).add(tested.bits_variable);
    text.add(tested.bit_index).add(tested.bit_value).add(tested.valid).add(tested.holds);
  }
  return text.bytes();
}
[[nodiscard]] inline std::vector<std::uint8_t> cdr(const msg::Program& program) {
  CdrText text;
  text.add(program.stamp).add(program.robot).add(program.name).add(program.hash);
  text.add(program.start_state);
  text.add(static_cast<std::uint32_t>(program.files.size()));
  for (const auto& file : program.files) text.add(file.path).add(file.text);
  text.add(static_cast<std::uint32_t>(program.states.size()));
  for (const auto& state : program.states) {
    text.add(state.name).add(state.file).add(state.line);
    text.add(state.perceptual_schemas).add(state.motor_schemas);
  }
  text.add(static_cast<std::uint32_t>(program.transitions.size()));
  for (const auto& each : program.transitions) {
    text.add(each.from_state).add(each.to_state).add(each.file).add(each.line);
    text.add(each.bits_variable).add(each.bit_index).add(each.bit_value).add(each.bit_update);
    text.add(each.reset_variables);
  }
  return text.bytes();
}
[[nodiscard]] inline std::vector<std::uint8_t> cdr(const msg::ObjectMap& map) {
  CdrText text;
  text.add(map.stamp).add(static_cast<std::uint32_t>(map.objects.size()));
  for (const auto& object : map.objects) {
    text.add(object.id).add(object.object_class).add(object.x_m).add(object.y_m);
    text.add(object.variance_xx).add(object.variance_xy).add(object.variance_yy);
    text.add(object.certainty).add(object.decay_per_s).add(object.last_seen);
    text.add(object.seen_by).add(object.held_by);
  }
  text.add(static_cast<std::uint32_t>(map.robots.size()));
  for (const auto& robot : map.robots) {
    text.add(robot.name).add(robot.x_m).add(robot.y_m).add(robot.heading_rad);
    text.add(robot.variance_xx).add(robot.variance_xy).add(robot.variance_yy);
    text.add(robot.age_s).add(robot.silent);
  }
  return text.bytes();
}
[[nodiscard]] inline std::vector<std::uint8_t> cdr(const msg::OccupancyGrid& grid) {
  CdrText text;
  text.add(grid.header.stamp).add(grid.header.frame_id).add(grid.info.map_load_time);
  text.add(grid.info.resolution).add(grid.info.width).add(grid.info.height);
  const auto& [position, orientation] = grid.info.origin;
  text.add(position.x).add(position.y).add(position.z);
  text.add(orientation.x).add(orientation.y).add(orientation.z).add(orientation.w);
  text.add(static_cast<std::uint32_t>(grid.data.size()));
  for (const auto cell : grid.data) text.add(cell);
  return text.bytes();
}
[[nodiscard]] inline std::vector<std::uint8_t> cdr(const msg::SimulationState& state) {
  CdrText text;
  text.add(state.stamp).add(state.simulation).add(state.scenario).add(state.step);
  text.add(state.simulated_s).add(state.paused).add(state.rate).add(state.contest);
  text.add(state.width_m).add(state.depth_m);
  text.add(static_cast<std::uint32_t>(state.bodies.size()));
  for (const auto& body : state.bodies) {
    text.add(body.name).add(body.kind).add(body.x_m).add(body.y_m).add(body.heading_rad);
    text.add(body.held_by);
  }
  text.add(static_cast<std::uint32_t>(state.faults.size()));
  for (const auto& fault : state.faults) text.add(fault.robot).add(fault.part).add(fault.fault);
  return text.bytes();
}

}  // namespace galilean::expect
