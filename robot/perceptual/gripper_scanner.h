// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean {
struct Devices;
}

namespace galilean::robot {

/// Tells what the gripper holds.
///
///   reads   comm_port
///   writes  bits_variable: bit `beam_index` is 1 while the infrared beam is broken, bit
///           `closed_index` while the servo stands at its closed stop. Nothing while the serial
///           line is down.
///   source  the paper
class GripperScanner final : public PerceptualSchema {
 public:
  static void describe(Declaration<GripperScanner>& is);
  void run(const Tick& tick) override;

 private:
  Variable<Bits>* bits_ = nullptr;
  unsigned beam_index_ = 0;
  unsigned closed_index_ = 1;
  const Devices* devices_ = nullptr;
};

}  // namespace galilean::robot
