// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/declaration.h"
#include "core/device/comm_port.h"
#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean {
struct Devices;
}

namespace galilean::robot {

/// Opens or closes the gripper.
///
///   reads     bits_variable, if it is given
///   commands  comm_port, in every tick
///   law       With bits_variable: close if bit `bit_index` is 1, open if it is 0, nothing
///             while the variable is invalid. Without it: what `command` says.
///   source    the paper
class MoveGripper final : public MotorSchema {
 public:
  static void describe(Declaration<MoveGripper>& is);
  void run(const Tick& tick) override;

 private:
  const Variable<Bits>* bits_ = nullptr;
  unsigned bit_index_ = 0;
  GripperCommand command_ = GripperCommand::kClose;
  const Devices* devices_ = nullptr;
};

}  // namespace galilean::robot
