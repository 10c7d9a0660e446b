// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/snapshot.h"

#include <algorithm>

#include "core/device/devices.h"
#include "core/device/frame_grabber.h"

namespace galilean::robot {
namespace {

using Values = std::array<double, Snapshot::VariableSample::kMostValues>;

Values values_of(const Shaft& shaft) noexcept {
  return {shaft.pose.position_m.x(), shaft.pose.position_m.y(), shaft.pose.heading_rad,
          shaft.speed_mps, shaft.turn_rate_radps};
}
Values values_of(const Image& image) noexcept {
  return {Image::kWidth, Image::kHeight, static_cast<double>(image.frame)};
}
Values values_of(const Locate& locate) noexcept {
  const Mat2& covariance_m2 = locate.covariance_m2;
  return {locate.position_m.x(), locate.position_m.y(), covariance_m2(0, 0),
          covariance_m2(0, 1),   covariance_m2(1, 1),   locate.radius_m};
}
Values values_of(const Bits& bits) noexcept {
  return {static_cast<double>(bits.value)};
}
Values values_of(const Force& force) noexcept {
  return {force.value.x(), force.value.y()};
}

template <class T>
Snapshot::VariableSample sample(const Variable<T>& variable, Time now) noexcept {
  Snapshot::VariableSample sample{
      .valid = variable.valid_at(now),
      .certainty = variable.certainty_at(now),
      .decay_per_s = variable.constant ? 0 : variable.reliability.decay_per_s,
      .updated = variable.reliability.stamp,
      .values = values_of(variable.value)};
  if constexpr (std::is_same_v<T, Locate>) sample.object = variable.value.object;
  return sample;
}

void copy_sightings(const Locate& locate, std::size_t variable, Snapshot& to) noexcept {
  if (to.frame == 0 || locate.sightings_frame != to.frame) return;
  for (const Sighting& sighting : locate.sightings)
    to.sightings.push_back({variable, locate.object, sighting});
}

void copy_variables(const RunningProgram& program, Snapshot& to) noexcept {
  program.variables.for_each([&]<class T>(const Variable<T>& variable) {
    if constexpr (std::is_same_v<T, Locate>)
      copy_sightings(variable.value, to.variables.size(), to);
    to.variables.push_back(sample(variable, to.now));
  });
}

void copy_forces(const RunningProgram& program, Snapshot& to) noexcept {
  for (const auto& label : program.description->forces) {
    const bool active = program.schemas[label.runner].last_run() == to.tick;
    for (const auto& force : program.variables.all<Force>())
      if (force.name == label.variable) to.forces.push_back({force.value.value, active});
  }
}

void copy_failures(const RunningProgram& program, Snapshot& to) noexcept {
  for (std::size_t i = 0; i < program.schemas.size(); ++i)
    if (program.schemas[i].failed()) to.failures.push_back({i, program.schemas[i].failure()});
}

void copy_program(const RunningProgram& program, Snapshot& to) noexcept {
  to.program = program.description->id;
  to.state = program.state;
  to.state_since = program.state_since;
  to.uses_camera = program.devices.uses_camera;
  copy_variables(program, to);
  copy_forces(program, to);
  copy_failures(program, to);
}

void copy_tick(const TickView& view, Snapshot& to) noexcept {
  to.program = 0;
  to.uses_camera = false;
  to.now = view.tick.now;
  to.tick = view.tick.number;
  to.tick_period = view.tick.period;
  to.tick_time = view.tick_time;
  to.overruns = view.overruns;
  to.transitions = view.transitions;
  to.standstill = view.standstill;
  to.fault = view.fault;
  to.out_of_service = view.out_of_service;
  to.in_probation = view.in_probation;
  to.health = view.health;
  to.pose = view.pose;
  to.speed_mps = view.speed_mps;
  to.turn_rate_radps = view.turn_rate_radps;
  to.frame = view.devices.frame_grabber.frame().number;
  to.frame_captured = view.devices.frame_grabber.frame().captured;
  to.view_angle_rad = view.devices.frame_grabber.geometry().view_angle_rad;
  to.variables.clear();
  to.forces.clear();
  to.failures.clear();
  to.sightings.clear();
}

}  // namespace

void SnapshotTap::on_event(const Event& event) noexcept {
  if (!events_of_this_tick_.push_back(event)) ++lost_events_;
}

void SnapshotTap::on_tick(const TickView& view) noexcept {
  Snapshot& next = snapshots_.writing();
  copy_tick(view, next);
  if (view.program) copy_program(*view.program, next);
  if (restart_longest_.exchange(false, std::memory_order_relaxed)) longest_tick_time_ = {};
  longest_tick_time_ = std::max(longest_tick_time_, view.tick_time);
  next.longest_tick_time = longest_tick_time_;
  snapshots_.publish();
  hand_over_events();
}

void SnapshotTap::hand_over_events() noexcept {
  for (const Event& event : events_of_this_tick_)
    if (!events_.push(event)) ++lost_events_;
  events_of_this_tick_.clear();
}

}  // namespace galilean::robot
