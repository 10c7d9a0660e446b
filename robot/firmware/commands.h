// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "robot/firmware/message_type.h"
#include "robot/firmware/protocol.h"

namespace galilean::robot::firmware {

/// Robot to board: opens a session.
struct Hello {
  static constexpr auto kType = MessageType::kHello;
  std::uint8_t version = kProtocolVersion;

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.version);
  }
};

/// PWM below which a motor does not move, signed as it is applied.
struct DeadZones {
  std::int16_t left_forward = 0;
  std::int16_t right_forward = 0;
  std::int16_t left_reverse = 0;
  std::int16_t right_reverse = 0;

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.left_forward), io(m.right_forward), io(m.left_reverse), io(m.right_reverse);
  }
};

/// Robot to board: the settings of its program's motor_drive. The motors do not move before they
/// came.
struct Parameters {
  static constexpr auto kType = MessageType::kParameters;
  float proportional_gain = 0;         ///< PWM per tick/s of speed error
  float integral_gain = 0;             ///< PWM per tick of summed speed error
  float derivative_gain = 0;           ///< PWM per tick/s² of measured acceleration
  float feedforward_gain = 0;          ///< PWM per tick/s of wanted speed, above the dead zone
  DeadZones straight_dead_zones;       ///< for both treads running the same way
  DeadZones turn_dead_zones;           ///< for an in-place turn, in which the treads scrub
  float forward_velocity_ticks_s = 0;  ///< the fastest speed of a wheel
  float turning_velocity_ticks_s = 0;  ///< the fastest speed of a wheel in an in-place turn
  float acceleration_ticks_s2 = 0;
  std::uint32_t timeout_ms = 0;  ///< how long a Drive lasts unless a new one comes

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.proportional_gain), io(m.integral_gain), io(m.derivative_gain), io(m.feedforward_gain);
    DeadZones::fields(m.straight_dead_zones, io);
    DeadZones::fields(m.turn_dead_zones, io);
    io(m.forward_velocity_ticks_s), io(m.turning_velocity_ticks_s), io(m.acceleration_ticks_s2);
    io(m.timeout_ms);
  }
};

/// Robot to board: replaces the motion under way. Speeds ramp from their present values. The same
/// Drive with the same sequence, sent again, goes on with its motion. The motors stop when neither
/// came for DriveTrain::kStopTimer_ms.
struct Drive {
  static constexpr auto kType = MessageType::kDrive;
  std::int16_t left_speed_counts_s = 0;   ///< forward positive; 16 counts are a tick
  std::int16_t right_speed_counts_s = 0;  ///< forward positive
  std::uint32_t left_limit_counts = 0;    ///< travel after which the wheel stands; 0: no limit
  std::uint32_t right_limit_counts = 0;   ///< travel after which the wheel stands; 0: no limit

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.left_speed_counts_s), io(m.right_speed_counts_s);
    io(m.left_limit_counts), io(m.right_limit_counts);
  }
};

/// Robot to board: brakes both motors at once, without a ramp.
struct Stop {
  static constexpr auto kType = MessageType::kStop;

  template <class Self, class Io>
  static constexpr void fields(Self&, Io&) {}
};

struct Gripper {
  static constexpr auto kType = MessageType::kGripper;
  std::uint8_t close = 0;  ///< 1 closes, 0 opens

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.close);
  }
};

/// Robot to board: asks for a Status now, besides those that the board sends by itself.
struct StatusRequest {
  static constexpr auto kType = MessageType::kStatusRequest;

  template <class Self, class Io>
  static constexpr void fields(Self&, Io&) {}
};

}  // namespace galilean::robot::firmware
