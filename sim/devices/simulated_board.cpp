// SPDX-License-Identifier: BSD-3-Clause
#include "sim/devices/simulated_board.h"

#include <algorithm>

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

SimulatedBoard::SimulatedBoard(RobotBody& body, robot::ByteStream& line,
                               const std::string& robot_name, std::uint16_t boot_count)
    : body_(body), line_(line), firmware_(*this, identity_of(robot_name, boot_count)) {}

std::size_t SimulatedBoard::receive(std::span<std::uint8_t> bytes) {
  const std::size_t count = line_.read(bytes);
  heard_ = heard_ || count > 0;
  return count;
}

}  // namespace galilean::sim
