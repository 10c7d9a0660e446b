// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "robot/firmware/drive_train.h"
#include "robot/firmware/gripper_servo.h"
#include "robot/firmware/hardware.h"
#include "robot/firmware/held_switches.h"
#include "robot/firmware/messages.h"
#include "robot/firmware/protocol.h"
#include "robot/firmware/transmitter.h"

namespace galilean::robot::firmware {

inline constexpr std::array<std::uint8_t, 3> kFirmwareVersion{2, 0, 0};

/// The microcontroller's program. A board's main loop, or the simulator, makes one on power-up and
/// calls `update` at least every `kPeriod_ms`, with the milliseconds since then.
///
///   serial bytes → messages → drive train, gripper
///   encoders → speed loops at 500 Hz → PWM;   all that it knows → Status at 50 Hz
///
/// It uses no heap and no exceptions, and never blocks. docs/SERIAL_PROTOCOL.md describes its
/// protocol.
class Controller {
 public:
  static constexpr std::uint32_t kPeriod_ms = 2;
  static constexpr std::uint32_t kStatusPeriod_ms = 20;
  static constexpr std::uint32_t kLongestStep_ms = 20;

  struct Identity {
    std::array<std::uint8_t, 16> name{};  ///< ASCII, filled up with zeros
    std::uint16_t boot_count = 1;         ///< differs from that of the start before
  };

  Controller(Hardware& hardware, const Identity& identity);
  void update(std::uint32_t now_ms);

 private:
  void receive();
  void handle(const Frame& frame);
  Result obey(const Frame& frame);
  Result greet(const Frame& frame);
  Result configure(const Frame& frame);
  Result drive(const Frame& frame);
  Result stop(const Frame& frame);
  void stop_motion();
  Result grip(const Frame& frame);
  Result report(const Frame& frame);
  void control();
  void send_status();

  Hardware& hardware_;
  Identity identity_;
  FrameDecoder decoder_;
  Transmitter transmitter_;
  DriveTrain drive_train_;
  GripperServo gripper_;
  HeldSwitches switches_;
  Inputs inputs_;
  Outputs outputs_;
  std::uint16_t switches_on_ = 0;
  std::uint16_t last_command_ = 0;
  std::optional<std::uint16_t> motion_;  ///< sequence of the newest Drive, until it is stopped
  std::uint32_t now_ms_ = 0;
  std::uint32_t last_control_ms_ = 0;
  std::uint32_t last_status_ms_ = 0;
};

}  // namespace galilean::robot::firmware
