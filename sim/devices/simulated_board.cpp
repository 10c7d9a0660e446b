// SPDX-License-Identifier: BSD-3-Clause
#include "sim/devices/simulated_board.h"

#include <algorithm>
#include <array>
#include <utility>

namespace galilean::sim {
namespace {

robot::firmware::Controller::Identity identity_of(const std::string& name, std::uint16_t boot) {
  robot::firmware::Controller::Identity identity;
  const std::size_t length = std::min(name.size(), identity.name.size());
  std::copy_n(name.begin(), length, identity.name.begin());
  identity.boot_count = boot;
  return identity;
}

}  // namespace

SimulatedBoard::SimulatedBoard(RobotBody& body, robot::ByteStream& line, std::string robot_name,
                               BootMemory memory)
    : body_(body), line_(line), robot_name_(std::move(robot_name)), memory_(std::move(memory)) {
  power_up();
}

void SimulatedBoard::power_up() {
  powered_up_ms_ = now_ms_;
  at_power_up_ = body_.inputs();
  robot::firmware::Hardware& pins = *this;
  firmware_.emplace(pins, identity_of(robot_name_, memory_.count_start()));
}

void SimulatedBoard::set_power(bool on) {
  if (on == firmware_.has_value()) return;
  if (on) return power_up();
  firmware_.reset();
  body_.apply({});
}

void SimulatedBoard::update(std::uint32_t now_ms) {
  now_ms_ = now_ms;
  if (firmware_) return firmware_->update(now_ms - powered_up_ms_);
  std::array<std::uint8_t, 512> lost;
  while (line_.read(lost) > 0) {
  }
}

/// A board counts in memory that it loses with its power, and begins at 0.
robot::firmware::Inputs SimulatedBoard::read() {
  auto inputs = body_.inputs();
  inputs.left_encoder_counts -= at_power_up_.left_encoder_counts;
  inputs.right_encoder_counts -= at_power_up_.right_encoder_counts;
  return inputs;
}

std::size_t SimulatedBoard::receive(std::span<std::uint8_t> bytes) {
  const std::size_t count = line_.read(bytes);
  heard_ = heard_ || count > 0;
  return count;
}

}  // namespace galilean::sim
