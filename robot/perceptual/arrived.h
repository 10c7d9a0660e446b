// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Trigger: the robot is where something is, seen or remembered.
///
///   reads   locate_variable, shaft_variable
///   writes  bits_variable: bit `bit_index` is 1 if both are valid and their centres are at most
///           `radius` apart, else 0
///   source  the paper's perceptual triggers
class Arrived final : public PerceptualSchema {
 public:
  static void describe(Declaration<Arrived>& is);
  void run(const Tick& tick) override;

 private:
  const Variable<Locate>* object_ = nullptr;
  const Variable<Shaft>* shaft_ = nullptr;
  double radius_m_ = 0;
  Variable<Bits>* bits_ = nullptr;
  unsigned bit_index_ = 0;
};

}  // namespace galilean::robot
