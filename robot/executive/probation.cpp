// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/probation.h"

#include "core/device/device_names.h"

namespace galilean::robot {

void Probation::begin(Time now, const ProbationRules& rules, const DeviceHealth& health) noexcept {
  *this = Probation();
  active_ = true;
  end_ = now + rules.length;
  most_transitions_per_s_ = static_cast<std::size_t>(rules.most_transitions_per_s);
  healthy_before_ = health;
}

void Probation::keep(Memory& memory) noexcept {
  memory.keep(active_);
  memory.keep(verdict_.fault);
  memory.keep(verdict_.schema);
  verdict_.reason.keep(memory);
  memory.keep(end_);
  healthy_before_.keep(memory);
  memory.keep(overruns_in_a_row_);
  memory.keep(most_transitions_per_s_);
  for (Time& time : transition_times_) memory.keep(time);
  memory.keep(transitions_);
}

void Probation::fail(const Verdict& verdict) noexcept {
  if (verdict_.fault == Fault::kNone) verdict_ = verdict;
}

void Probation::note_schema_failure(std::uint32_t schema, const ShortText& reason) noexcept {
  fail({Fault::kSchemaThrew, schema, reason});
}

void Probation::note_transition(Time now) noexcept {
  const std::size_t number = transitions_++;
  if (number >= most_transitions_per_s_) {
    const std::size_t first = number - most_transitions_per_s_;
    const Time began = transition_times_[first % transition_times_.size()];
    if (now - began <= std::chrono::seconds(1)) fail({.fault = Fault::kThrashed});
  }
  transition_times_[number % transition_times_.size()] = now;
}

void Probation::note_health(const DeviceHealth& health) noexcept {
  const auto lost = [this](bool before, bool now, std::string_view device) {
    if (before && !now) fail({.fault = Fault::kDeviceLost, .reason = ShortText(device)});
  };
  lost(healthy_before_.comm_port, health.comm_port, kCommPortName);
  lost(healthy_before_.motor_drive, health.motor_drive, kMotorDriveName);
  lost(healthy_before_.frame_grabber, health.frame_grabber, kFrameGrabberName);
}

void Probation::note_tick(const DeviceHealth& health, bool overran) noexcept {
  note_health(health);
  overruns_in_a_row_ = overran ? overruns_in_a_row_ + 1 : 0;
  if (overruns_in_a_row_ >= kOverrunsInARow) fail({.fault = Fault::kOverran});
}

}  // namespace galilean::robot
