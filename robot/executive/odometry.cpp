// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/odometry.h"

#include <cmath>

#include "core/device/devices.h"
#include "core/device/motor_drive.h"

namespace galilean::robot {
namespace {

struct Motion {
  double distance_m = 0;
  double turn_rad = 0;
  double speed_mps = 0;
  double turn_rate_radps = 0;
};

void advance(Shaft& shaft, const Motion& motion) noexcept {
  const double half_turn = motion.turn_rad / 2;
  const double chord_per_arc = std::abs(half_turn) < 1e-9 ? 1 : std::sin(half_turn) / half_turn;
  shaft.pose.position_m +=
      motion.distance_m * chord_per_arc * unit_vector(shaft.pose.heading_rad + half_turn);
  shaft.pose.heading_rad = wrap_angle(shaft.pose.heading_rad + motion.turn_rad);
  shaft.speed_mps = motion.speed_mps;
  shaft.turn_rate_radps = motion.turn_rate_radps;
}

}  // namespace

Odometry::Travel Odometry::since_last(const ControllerStatus& status) noexcept {
  const Travel now{status.left_travel_m, status.right_travel_m, status.epoch};
  const bool anew = !started_ || now.epoch != last_.epoch;
  const Travel difference =
      anew ? Travel{} : Travel{now.left_m - last_.left_m, now.right_m - last_.right_m, now.epoch};
  started_ = true;
  last_ = now;
  return difference;
}

void Odometry::update(const Devices& devices, RunningProgram* program, const Tick& tick) noexcept {
  if (!devices.comm_port.healthy()) {
    // The board brakes by itself when it hears nothing. The speeds before that are none of now.
    own_.speed_mps = own_.turn_rate_radps = 0;
    return;
  }
  const ControllerStatus& status = devices.comm_port.status();
  const double track_m = 2 * devices.motor_drive.turn_radius_m();
  const Travel travel = since_last(status);
  const Motion motion{
      .distance_m = (travel.left_m + travel.right_m) / 2,
      .turn_rad = (travel.right_m - travel.left_m) / track_m,
      .speed_mps = (status.left_speed_mps + status.right_speed_mps) / 2,
      .turn_rate_radps = (status.right_speed_mps - status.left_speed_mps) / track_m};
  advance(own_, motion);
  if (!program) return;
  auto& shafts = program->variables.all<Shaft>();
  for (std::size_t i = 0; i < shafts.size(); ++i) {
    if (!shafts[i].reliability.valid) shafts[i].value.pose = program->start_poses[i];
    advance(shafts[i].value, motion);
    shafts[i].mark_written(1, tick.now, tick.number);
  }
}

void Odometry::keep(Memory& memory) noexcept {
  memory.keep(started_);
  memory.keep(last_.left_m);
  memory.keep(last_.right_m);
  memory.keep(last_.epoch);
  memory.keep(own_.pose);
  memory.keep(own_.speed_mps);
  memory.keep(own_.turn_rate_radps);
}

Pose2 Odometry::pose(const RunningProgram* program) const noexcept {
  const bool has_shaft = program && !program->variables.all<Shaft>().empty();
  return has_shaft ? program->variables.all<Shaft>().front().value.pose : own_.pose;
}

}  // namespace galilean::robot
