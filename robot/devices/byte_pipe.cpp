// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/byte_pipe.h"

#include <algorithm>
#include <utility>

namespace galilean::robot {

BytePipe::BytePipe(std::string name) : name_(std::move(name)) {}

void BytePipe::connect(bool connected) {
  connected_ = connected;
  to_board_.clear();
  to_robot_.clear();
}

std::size_t BytePipe::Buffer::read(std::span<std::uint8_t> bytes) {
  const std::size_t count = std::min(bytes.size(), written_ - read_);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = bytes_[read_++ % kBytes];
  return count;
}

std::size_t BytePipe::Buffer::write(std::span<const std::uint8_t> bytes) {
  const std::size_t count = std::min(bytes.size(), kBytes - (written_ - read_));
  for (std::size_t i = 0; i < count; ++i) bytes_[written_++ % kBytes] = bytes[i];
  return count;
}

std::size_t BytePipe::End::read(std::span<std::uint8_t> bytes) {
  return is_open() ? incoming_.read(bytes) : 0;
}

std::size_t BytePipe::End::write(std::span<const std::uint8_t> bytes) {
  return is_open() ? outgoing_.write(bytes) : 0;
}

std::string BytePipe::End::problem() const {
  return is_open() ? "" : "The serial line " + name() + " is unplugged: plug it in again.";
}

}  // namespace galilean::robot
