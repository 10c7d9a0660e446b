// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Trigger: the robot no longer knows where something is.
///
///   reads   locate_variable
///   writes  bits_variable: bit `bit_index` is 1 if the object is invalid or its certainty is below
///           `min_certainty`, else 0. Choose it lower than that of `seen`, or states flutter.
///   source  the paper's perceptual triggers
class Lost final : public PerceptualSchema {
 public:
  static void describe(Declaration<Lost>& is);
  void run(const Tick& tick) override;

 private:
  const Variable<Locate>* object_ = nullptr;
  double min_certainty_ = 0;
  Variable<Bits>* bits_ = nullptr;
  unsigned bit_index_ = 0;
};

}  // namespace galilean::robot
