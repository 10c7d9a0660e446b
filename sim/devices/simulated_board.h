// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "robot/devices/byte_stream.h"
#include "robot/firmware/controller.h"
#include "robot/firmware/hardware.h"
#include "sim/world/robot_body.h"

namespace galilean::sim {

/// A microcontroller board in the simulated world. It runs the real firmware. Its pins are a
/// robot's body, and its serial line is a byte stream. Making one is power-up.
class SimulatedBoard final : private robot::firmware::Hardware {
 public:
  /// `boot_count` must differ from that of the power-up before.
  SimulatedBoard(RobotBody& body, robot::ByteStream& line, const std::string& robot_name,
                 std::uint16_t boot_count = 1);

  /// Runs the firmware. Requires: it is called every few milliseconds, with the time since
  /// power-up.
  void update(std::uint32_t now_ms) { firmware_.update(now_ms); }
  /// Returns whether the robot on the other end was heard.
  [[nodiscard]] bool heard() const noexcept { return heard_; }

 private:
  robot::firmware::Inputs read() override { return body_.inputs(); }
  void write(const robot::firmware::Outputs& outputs) override { body_.apply(outputs); }
  std::size_t receive(std::span<std::uint8_t> bytes) override;
  std::size_t send(std::span<const std::uint8_t> bytes) override { return line_.write(bytes); }

  RobotBody& body_;
  robot::ByteStream& line_;
  bool heard_ = false;
  robot::firmware::Controller firmware_;
};

}  // namespace galilean::sim
