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

}  // namespace galilean::expect
