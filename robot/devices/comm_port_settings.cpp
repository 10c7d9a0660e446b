// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/comm_port_settings.h"

#include "core/device/device_names.h"

namespace galilean::robot {

void CommPortSettings::describe(Declaration<CommPortSettings>& is) {
  using S = CommPortSettings;
  is.help("The serial line to the microcontroller.");
  is.configures(kCommPortName);
  is.text(&S::device, "device", "/dev/ttyUSB0", "path of the serial device or pseudo-terminal");
  is.number(&S::baud, "baud", unit::kNone, 115200, "bits a second; a pseudo-terminal ignores it")
      .range(9600, 921600);
  is.number(&S::timeout_s, "timeout", unit::kSecond, 0.5,
            "silence after which the line counts as lost and the robot stops")
      .range(0.05, 120);
}

}  // namespace galilean::robot
