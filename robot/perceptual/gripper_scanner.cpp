// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/gripper_scanner.h"

#include "core/device/comm_port.h"
#include "core/device/device_names.h"
#include "core/device/devices.h"

namespace galilean::robot {

void GripperScanner::describe(Declaration<GripperScanner>& is) {
  is.help("Tells whether something stands in the gripper and whether the gripper is closed.");
  is.updates(&GripperScanner::bits_, "bits_variable", "a bit for the beam, one for the servo");
  is.number(&GripperScanner::beam_index_, "beam_index", unit::kNone, 0,
            "the bit that is 1 while the infrared beam is broken")
      .range(0, 31)
      .bit_of("bits_variable")
      .role(Role::kGripperBeam);
  is.number(&GripperScanner::closed_index_, "closed_index", unit::kNone, 1,
            "the bit that is 1 while the gripper is closed")
      .range(0, 31)
      .bit_of("bits_variable");
  is.needs(kCommPortName);
  is.uses_devices(&GripperScanner::devices_);
}

void GripperScanner::run(const Tick& tick) {
  const CommPort& line = devices_->comm_port;
  if (!line.healthy()) return;
  Bits bits = bits_->value;
  bits.assign(beam_index_, line.status().beam_broken);
  bits.assign(closed_index_, line.status().gripper_closed);
  bits_->write(bits, 1, tick.now, tick.number);
}

}  // namespace galilean::robot
