// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Trigger: a time has passed since the state was entered.
///
///   writes  bits_variable: bit `bit_index` is 1 once `duration` has passed since a state that
///           lists this schema was entered, 0 before
///   source  the paper
class TimeDetector final : public PerceptualSchema {
 public:
  static void describe(Declaration<TimeDetector>& is);
  void activate(const Tick& tick) override;
  void run(const Tick& tick) override;
  void keep(Memory& memory) noexcept override { memory.keep(activated_); }

 private:
  Variable<Bits>* bits_ = nullptr;
  unsigned bit_index_ = 0;
  double duration_s_ = 0;
  Time activated_{};
};

}  // namespace galilean::robot
