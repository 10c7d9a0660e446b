// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean {
struct Devices;
}

namespace galilean::robot {

/// Copies the bumper switches into bits.
///
///   reads   comm_port
///   writes  bits_variable: bit i is 1 while bumper i is pressed (0 front, then counter-clockwise);
///           with `bit_index` that bit alone. Nothing while the serial line is down.
///   source  the paper
class BumperScanner final : public PerceptualSchema {
 public:
  static constexpr int kAllBumpers = -1;

  static void describe(Declaration<BumperScanner>& is);
  void run(const Tick& tick) override;

 private:
  Variable<Bits>* bits_ = nullptr;
  int bit_index_ = kAllBumpers;
  const Devices* devices_ = nullptr;
};

}  // namespace galilean::robot
