// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace galilean::robot::firmware {

/// Full power of an H-bridge; the sign is the direction, forward positive.
inline constexpr std::int16_t kFullPwm = 1000;
/// Shaft encoder counts in one of the paper's ticks (a tick is 1/3.25 cm).
inline constexpr std::int32_t kCountsPerTick = 16;

/// The readings of the board's input pins.
struct Inputs {
  std::int32_t left_encoder_counts = 0;   ///< forward counts up; wraps around
  std::int32_t right_encoder_counts = 0;  ///< forward counts up; wraps around
  std::uint8_t bumpers = 0;               ///< bit n: switch n is pressed
  bool beam_broken = false;               ///< something stands between the gripper's hands
};

/// The values for the board's output pins.
struct Outputs {
  std::int16_t left_pwm = 0;          ///< -kFullPwm … kFullPwm; 0 brakes
  std::int16_t right_pwm = 0;         ///< -kFullPwm … kFullPwm; 0 brakes
  std::int16_t gripper_permille = 0;  ///< where the servo is to stand, 0 open … 1000 closed
};

/// The interface between the firmware and what it runs on. A port to a board, or the simulator,
/// implements it. No method may block.
class Hardware {
 public:
  virtual Inputs read() = 0;
  virtual void write(const Outputs& outputs) = 0;
  /// Reads bytes that came over the serial line. Returns how many, 0 when none wait.
  virtual std::size_t receive(std::span<std::uint8_t> bytes) = 0;
  /// Writes bytes to the serial line. Returns how many it took, 0 when its buffer is full.
  virtual std::size_t send(std::span<const std::uint8_t> bytes) = 0;

 protected:
  ~Hardware() = default;
};

}  // namespace galilean::robot::firmware
