// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

#include "robot/devices/byte_stream.h"
#include "robot/firmware/controller.h"
#include "sim/world/robot_body.h"

namespace galilean::sim {

/// A board in the simulated world whose pins and line are looked at: when it heard its last good
/// Drive, and what it gives the motors.
class WatchedBoard final : private robot::firmware::Hardware {
 public:
  WatchedBoard(RobotBody& body, robot::ByteStream& line) : body_(body), line_(line) {}

  void update(std::uint32_t now_ms) {
    now_ms_ = now_ms;
    firmware_.update(now_ms);
  }
  [[nodiscard]] std::uint32_t last_drive_ms() const { return last_drive_ms_; }
  /// Returns where the wheels stood when the last good Drive was heard.
  [[nodiscard]] const robot::firmware::Inputs& at_last_drive() const { return at_last_drive_; }
  [[nodiscard]] const robot::firmware::Outputs& outputs() const { return outputs_; }

 private:
  robot::firmware::Inputs read() override { return body_.inputs(); }
  void write(const robot::firmware::Outputs& outputs) override {
    outputs_ = outputs;
    body_.apply(outputs);
  }
  std::size_t receive(std::span<std::uint8_t> bytes) override {
    const std::size_t count = line_.read(bytes);
    for (const std::uint8_t byte : bytes.first(count))
      if (decoder_.push(byte)) note(decoder_.frame());
    return count;
  }
  std::size_t send(std::span<const std::uint8_t> bytes) override { return line_.write(bytes); }

  void note(const robot::firmware::Frame& frame) {
    robot::firmware::Drive drive;
    if (frame.type != static_cast<std::uint8_t>(drive.kType) || !unpack(frame, drive)) return;
    last_drive_ms_ = now_ms_;
    at_last_drive_ = body_.inputs();
  }

  RobotBody& body_;
  robot::ByteStream& line_;
  robot::firmware::FrameDecoder decoder_;
  robot::firmware::Outputs outputs_;
  robot::firmware::Inputs at_last_drive_;
  std::uint32_t last_drive_ms_ = 0;
  std::uint32_t now_ms_ = 0;
  robot::firmware::Controller firmware_{*this, {}};
};

}  // namespace galilean::sim
