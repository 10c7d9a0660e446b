// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// Trigger: the robot has touched something without a break for so long that it must be wedged.
///
///   reads   contact_variable (bits), such as the bumpers
///   writes  bits_variable: bit `bit_index` is 1 once some bit of contact_variable has been 1 in
///           every tick for `duration`, else 0. Changing states does not begin the time anew as
///           long as each of them lists this schema.
///   source  our own: treads slip when a robot is wedged, so that dead reckoning cannot tell
class StuckDetector final : public PerceptualSchema {
 public:
  static void describe(Declaration<StuckDetector>& is);
  void run(const Tick& tick) override;
  void keep(Memory& memory) noexcept override {
    memory.keep(free_);
    memory.keep(last_tick_);
  }

 private:
  const Variable<Bits>* contact_ = nullptr;
  double duration_s_ = 0;
  Variable<Bits>* bits_ = nullptr;
  unsigned bit_index_ = 0;
  Time free_{};  ///< when it last touched nothing
  std::uint64_t last_tick_ = 0;
};

}  // namespace galilean::robot
