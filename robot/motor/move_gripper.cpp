// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/move_gripper.h"

#include "core/device/device_names.h"
#include "core/device/devices.h"

namespace galilean::robot {

void MoveGripper::describe(Declaration<MoveGripper>& is) {
  is.help("Opens or closes the gripper, as a bit or as the program says.");
  is.reads(&MoveGripper::bits_, "bits_variable",
           "if given, its bit moves the gripper: 1 closes it, 0 opens it")
      .optional();
  is.number(&MoveGripper::bit_index_, "bit_index", unit::kNone, 0, "which bit of bits_variable")
      .range(0, 31)
      .only_with("bits_variable");
  is.choice(&MoveGripper::command_, "command", {"open", "close"}, "close",
            "what the gripper does if there is no bits_variable")
      .only_without("bits_variable")
      .role(Role::kGripperCommand);
  is.drives(kGripperName);
  is.needs(kCommPortName);
  is.uses_devices(&MoveGripper::devices_);
}

void MoveGripper::run(const Tick& tick) {
  if (!bits_) {
    devices_->comm_port.command_gripper(command_);
  } else if (bits_->valid_at(tick.now)) {
    const bool close = bits_->value.test(bit_index_);
    devices_->comm_port.command_gripper(close ? GripperCommand::kClose : GripperCommand::kOpen);
  }
}

}  // namespace galilean::robot
