// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "robot/devices/byte_stream.h"

namespace galilean::robot {

/// A serial device or pseudo-terminal in raw, non-blocking mode. It opens again by itself after a
/// loss.
class SerialPort final : public ByteStream {
 public:
  SerialPort(std::string device, int baud);
  ~SerialPort() override;
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  std::size_t read(std::span<std::uint8_t> bytes) override;
  std::size_t write(std::span<const std::uint8_t> bytes) override;
  void maintain(Time now) override;
  [[nodiscard]] bool is_open() const override { return file_ >= 0; }
  [[nodiscard]] std::string problem() const override { return problem_; }
  [[nodiscard]] const std::string& name() const override { return device_; }

 private:
  void open_device();
  void set_up_line();
  void lose(std::string problem);

  std::string device_;
  int baud_;
  int file_ = -1;
  std::string problem_;
  Time last_attempt_{};
  bool attempted_ = false;
};

}  // namespace galilean::robot
