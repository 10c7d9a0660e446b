// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/catalog/declaration.h"
#include "core/random.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Wanders: a unit force in a random heading, which is held for a while.
///
///   reads   shaft_variable
///   writes  result (force), with the shaft's certainty
///   law     |F| = 1, heading drawn evenly from all when the schema is activated and every
///           `persistence` seconds. The heading is held in the global frame: held in the robot's
///           own it would turn with the robot, which would then only spin.
///   source  Arkin 1989; v_Noise of Clay
class Noise final : public MotorSchema {
 public:
  static void describe(Declaration<Noise>& is);
  void activate(const Tick& tick) override;
  void run(const Tick& tick) override;
  void keep(Memory& memory) noexcept override {
    random_.keep(memory);
    memory.keep(heading_);
    memory.keep(drawn_);
  }

 private:
  const Variable<Shaft>* shaft_ = nullptr;
  double persistence_s_ = 0;
  Random random_{0};
  Vec2 heading_ = Vec2::Zero();  ///< unit vector in the global frame
  std::optional<Time> drawn_;
  Variable<Force>* result_ = nullptr;
};

}  // namespace galilean::robot
