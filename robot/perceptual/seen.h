// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Trigger: the robot knows well enough where something is.
///
///   reads   locate_variable, shaft_variable
///   writes  bits_variable: bit `bit_index` is 1 if the object is valid, its certainty is at least
///           `min_certainty` and its centre within `max_range` of the robot's, else 0
///   source  the paper's perceptual triggers
class Seen final : public PerceptualSchema {
 public:
  static void describe(Declaration<Seen>& is);
  void run(const Tick& tick) override;

 private:
  [[nodiscard]] bool holds(Time now) const noexcept;

  const Variable<Locate>* object_ = nullptr;
  const Variable<Shaft>* shaft_ = nullptr;
  double min_certainty_ = 0;
  double max_range_m_ = 0;
  Variable<Bits>* bits_ = nullptr;
  unsigned bit_index_ = 0;
};

}  // namespace galilean::robot
