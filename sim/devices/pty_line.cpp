// SPDX-License-Identifier: BSD-3-Clause
#include "sim/devices/pty_line.h"

#include <fcntl.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace galilean::sim {

PtyLine::PtyLine(std::string link) : link_(std::move(link)) {}

PtyLine::~PtyLine() {
  unplug();
}

Error PtyLine::failure(const std::string& what) {
  Error error{link_ + ": " + what + " (" + std::strerror(errno) + ")"};
  unplug();
  return error;
}

Result<void> PtyLine::plug_in() {
  if (is_open()) return {};
  std::array<char, 128> device{};
  termios raw{};
  cfmakeraw(&raw);
  cfsetspeed(&raw, B115200);
  if (openpty(&board_side_, &robot_side_, device.data(), &raw, nullptr) != 0)
    return failure("no pseudo-terminal to be had; is /dev/pts mounted?");
  for (const int side : {board_side_, robot_side_}) fcntl(side, F_SETFD, FD_CLOEXEC);
  fcntl(board_side_, F_SETFL, O_NONBLOCK);
  unlink(link_.c_str());
  if (symlink(device.data(), link_.c_str()) != 0)
    return failure("the link to " + std::string(device.data()) + " cannot be made");
  return {};
}

void PtyLine::unplug() {
  if (board_side_ >= 0) close(board_side_);
  if (robot_side_ >= 0) close(robot_side_);
  board_side_ = robot_side_ = -1;
  unlink(link_.c_str());
}

std::size_t PtyLine::read(std::span<std::uint8_t> bytes) {
  if (!is_open()) return 0;
  const ssize_t count = ::read(board_side_, bytes.data(), bytes.size());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

std::size_t PtyLine::write(std::span<const std::uint8_t> bytes) {
  if (!is_open()) return bytes.size();  // as a UART sends although nobody listens
  const ssize_t count = ::write(board_side_, bytes.data(), bytes.size());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

}  // namespace galilean::sim
