// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/serial_port.h"

#include <fcntl.h>
#include <sys/file.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

namespace galilean::robot {
namespace {

constexpr Duration kOpenAgain = std::chrono::milliseconds(500);

struct Speed {
  int baud;
  speed_t code;
};
constexpr std::array kSpeeds{Speed{9600, B9600},     Speed{19200, B19200},   Speed{38400, B38400},
                             Speed{57600, B57600},   Speed{115200, B115200}, Speed{230400, B230400},
                             Speed{460800, B460800}, Speed{921600, B921600}};

std::optional<speed_t> speed_code(int baud) {
  for (const Speed& speed : kSpeeds)
    if (speed.baud == baud) return speed.code;
  return std::nullopt;
}

std::string advice(int error) {
  switch (error) {
    case ENOENT:
    case ENXIO:
    case ENODEV:
      return "plug the microcontroller in, or name its device in comm_port";
    case EACCES:
    case EPERM:
      return "give this user access, as a rule by adding it to the group dialout";
    case ENOTTY:
    case EISDIR:
    case ENOTDIR:
    case ENAMETOOLONG:
      return "name a serial device in comm_port";
    case EWOULDBLOCK:
      return "another process uses it: end that one first";
    default:
      return "check the cable and the device";
  }
}

std::string sentence(const std::string& device, const std::string& what, int error) {
  return "The serial line " + device + ' ' + what + " (" + std::strerror(error) +
         "): " + advice(error) + '.';
}

}  // namespace

SerialPort::SerialPort(std::string device, int baud)
    : device_(std::move(device)), baud_(baud), problem_("The serial line was not opened yet.") {}

SerialPort::~SerialPort() {
  if (is_open()) close(file_);
}

void SerialPort::maintain(Time now) {
  if (is_open() || (attempted_ && now - last_attempt_ < kOpenAgain)) return;
  attempted_ = true;
  last_attempt_ = now;
  open_device();
}

void SerialPort::open_device() {
  file_ = open(device_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (!is_open()) return lose(sentence(device_, "cannot be opened", errno));
  if (flock(file_, LOCK_EX | LOCK_NB) != 0) return lose(sentence(device_, "is taken", errno));
  set_up_line();
}

void SerialPort::set_up_line() {
  const auto speed = speed_code(baud_);
  if (!speed)
    return lose("comm_port asks for " + std::to_string(baud_) +
                " baud, which is none of the usual rates: 115200 is what the board expects.");
  termios line{};
  if (tcgetattr(file_, &line) != 0) return lose(sentence(device_, "is not a serial line", errno));
  cfmakeraw(&line);
  line.c_cflag |= CLOCAL | CREAD;
  // With VMIN 1 and O_NONBLOCK, an empty line gives EAGAIN, so that 0 bytes mean a hang-up.
  line.c_cc[VMIN] = 1;
  line.c_cc[VTIME] = 0;
  cfsetispeed(&line, *speed);
  cfsetospeed(&line, *speed);
  if (tcsetattr(file_, TCSANOW, &line) != 0)
    return lose(sentence(device_, "cannot be set up", errno));
  tcflush(file_, TCIOFLUSH);
  problem_.clear();
}

void SerialPort::lose(std::string problem) {
  if (is_open()) close(file_);
  file_ = -1;
  problem_ = std::move(problem);
}

std::size_t SerialPort::read(std::span<std::uint8_t> bytes) {
  if (!is_open() || bytes.empty()) return 0;
  const ssize_t count = ::read(file_, bytes.data(), bytes.size());
  if (count > 0) return static_cast<std::size_t>(count);
  const int error = count == 0 ? ENODEV : errno;
  if (error != EAGAIN && error != EINTR) lose(sentence(device_, "was lost", error));
  return 0;
}

std::size_t SerialPort::write(std::span<const std::uint8_t> bytes) {
  if (!is_open() || bytes.empty()) return 0;
  const ssize_t count = ::write(file_, bytes.data(), bytes.size());
  if (count >= 0) return static_cast<std::size_t>(count);
  if (errno != EAGAIN && errno != EINTR) lose(sentence(device_, "was lost", errno));
  return 0;
}

}  // namespace galilean::robot
