// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/state_hash.h"

#include "robot/executive/running_program.h"

namespace galilean::robot {
namespace {

void add(StateHash& hash, const Pose2& pose) noexcept {
  hash.add(pose.position_m);
  hash.add(pose.heading_rad);
}
void add(StateHash& hash, const Shaft& shaft) noexcept {
  add(hash, shaft.pose);
}
void add(StateHash& hash, const Image& image) noexcept {
  hash.add(image.frame);
}
void add(StateHash& hash, const Locate& locate) noexcept {
  hash.add(locate.position_m);
  for (int i = 0; i < 4; ++i) hash.add(locate.covariance_m2(i / 2, i % 2));
}
void add(StateHash& hash, const Bits& bits) noexcept {
  hash.add(std::uint64_t{bits.value});
}
void add(StateHash& hash, const Force& force) noexcept {
  hash.add(force.value);
}

}  // namespace

void add_pose(StateHash& hash, const Pose2& pose) noexcept {
  add(hash, pose);
}

void add_variables(StateHash& hash, const RunningProgram& program, Time now) noexcept {
  program.variables.for_each([&](const auto& variable) {
    hash.add(variable.name);
    add(hash, variable.value);
    hash.add(variable.certainty_at(now));
  });
}

}  // namespace galilean::robot
