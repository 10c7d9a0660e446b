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

}  // namespace galilean::expect
