// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"
#include "robot/devices/byte_stream.h"

namespace galilean::sim {

/// The board's end of a serial line that other processes open like a real one. It is a
/// pseudo-terminal behind a symbolic link. When it is unplugged, the link is removed and a process
/// that has it open gets a hang-up.
class PtyLine final : public robot::ByteStream {
 public:
  /// `link` is the path of the symbolic link under which robots find the line.
  explicit PtyLine(std::string link);
  ~PtyLine() override;
  PtyLine(const PtyLine&) = delete;
  PtyLine& operator=(const PtyLine&) = delete;

  Result<void> plug_in();
  void unplug();

  std::size_t read(std::span<std::uint8_t> bytes) override;
  std::size_t write(std::span<const std::uint8_t> bytes) override;
  void maintain(Time) override {}
  [[nodiscard]] bool is_open() const override { return board_side_ >= 0; }
  [[nodiscard]] std::string problem() const override {
    return is_open() ? std::string() : link_ + " is unplugged";
  }
  [[nodiscard]] const std::string& name() const override { return link_; }

 private:
  [[nodiscard]] Error failure(const std::string& what);

  std::string link_;
  int board_side_ = -1;
  int robot_side_ = -1;  ///< kept open, so that a robot that closes the line is no hang-up here
};

}  // namespace galilean::sim
