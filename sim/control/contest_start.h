// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "sim/world/world.h"

namespace galilean::sim {

/// Starts a contest as the paper's referee does: by a push of each robot's front bumper, for half a
/// second.
class ContestStart {
 public:
  explicit ContestStart(World& world) : world_(world) {}

  /// Pushes the bumpers and starts the referee's clock.
  void start() {
    push(1);
    steps_left_ = kPushSteps;
    world_.referee().start();
  }
  /// Lets go of the bumpers in time. It is called before each step of the world.
  void before_step() {
    if (steps_left_ > 0 && --steps_left_ == 0) push(0);
  }

 private:
  static constexpr std::uint64_t kPushSteps = 51;  // the call before the first step counts

  void push(std::uint8_t switches) {
    for (std::size_t i = 0; i < world_.robot_count(); ++i) world_.robot(i).push_bumpers(switches);
  }

  World& world_;
  std::uint64_t steps_left_ = 0;
};

}  // namespace galilean::sim
