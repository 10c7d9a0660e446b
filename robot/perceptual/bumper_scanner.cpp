// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/bumper_scanner.h"

#include "core/device/comm_port.h"
#include "core/device/device_names.h"
#include "core/device/devices.h"

namespace galilean::robot {

void BumperScanner::describe(Declaration<BumperScanner>& is) {
  is.help("Copies the eight bumper switches, or one of them, into bits.");
  is.updates(&BumperScanner::bits_, "bits_variable", "a bit for each bumper");
  is.number(&BumperScanner::bit_index_, "bit_index", unit::kNone, kAllBumpers,
            "the one bumper to scan; -1: all eight")
      .range(kAllBumpers, ControllerStatus::kBumpers - 1)
      .bit_of("bits_variable")
      .role(Role::kBumper);
  is.needs(kCommPortName);
  is.uses_devices(&BumperScanner::devices_);
}

void BumperScanner::run(const Tick& tick) {
  const CommPort& line = devices_->comm_port;
  if (!line.healthy()) return;
  const std::uint8_t pressed = line.status().bumpers;
  Bits bits = bits_->value;
  if (bit_index_ == kAllBumpers)
    bits.value = pressed;
  else
    bits.assign(static_cast<unsigned>(bit_index_), pressed >> bit_index_ & 1);
  bits_->write(bits, 1, tick.now, tick.number);
}

}  // namespace galilean::robot
