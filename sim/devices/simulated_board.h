// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robot/devices/byte_stream.h"
#include "robot/firmware/controller.h"
#include "robot/firmware/hardware.h"
#include "sim/devices/boot_memory.h"
#include "sim/world/robot_body.h"

namespace galilean::sim {

/// A microcontroller board in the simulated world. It runs the real firmware. Its pins are a
/// robot's body, and its serial line is a byte stream. Making one is power-up. Each power-up has
/// another boot count, and its time begins at 0.
class SimulatedBoard final : private robot::firmware::Hardware {
 public:
  SimulatedBoard(RobotBody& body, robot::ByteStream& line, std::string robot_name,
                 BootMemory memory = {});

  /// Runs the firmware. Requires: it is called every few milliseconds, with the simulated time.
  void update(std::uint32_t now_ms);
  /// Takes the board's power away, or gives it back. Without it the motors are shorted, and what
  /// comes over the line is lost.
  void set_power(bool on);
  /// Returns what went wrong with the memory of its boot count, or an empty text.
  [[nodiscard]] const std::string& problem() const noexcept { return memory_.problem(); }
  /// Returns whether the robot on the other end was heard.
  [[nodiscard]] bool heard() const noexcept { return heard_; }

 private:
  void power_up();
  robot::firmware::Inputs read() override;
  void write(const robot::firmware::Outputs& outputs) override { body_.apply(outputs); }
  std::size_t receive(std::span<std::uint8_t> bytes) override;
  std::size_t send(std::span<const std::uint8_t> bytes) override { return line_.write(bytes); }

  RobotBody& body_;
  robot::ByteStream& line_;
  std::string robot_name_;
  BootMemory memory_;
  bool heard_ = false;
  std::uint32_t now_ms_ = 0;
  std::uint32_t powered_up_ms_ = 0;
  robot::firmware::Inputs at_power_up_;
  std::optional<robot::firmware::Controller> firmware_;  ///< none: it has no power
};

}  // namespace galilean::sim
