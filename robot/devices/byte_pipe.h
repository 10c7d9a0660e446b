// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "robot/devices/byte_stream.h"

namespace galilean::robot {

/// A serial line inside one process, for the headless simulator. It has two ends with a buffer of
/// fixed size for each direction. It runs in one thread without system calls, so that every run
/// sees the same bytes.
class BytePipe {
 public:
  explicit BytePipe(std::string name);
  BytePipe(const BytePipe&) = delete;
  BytePipe& operator=(const BytePipe&) = delete;

  [[nodiscard]] ByteStream& robot_end() { return robot_end_; }
  [[nodiscard]] ByteStream& board_end() { return board_end_; }
  /// Unplugs the line or plugs it in again. Bytes that were on their way are lost.
  void connect(bool connected);

 private:
  class Buffer {
   public:
    std::size_t read(std::span<std::uint8_t> bytes);
    std::size_t write(std::span<const std::uint8_t> bytes);
    void clear() { read_ = written_ = 0; }

   private:
    static constexpr std::size_t kBytes = 1024;
    std::array<std::uint8_t, kBytes> bytes_{};
    std::size_t read_ = 0;
    std::size_t written_ = 0;
  };

  class End final : public ByteStream {
   public:
    End(const BytePipe& pipe, Buffer& incoming, Buffer& outgoing)
        : pipe_(pipe), incoming_(incoming), outgoing_(outgoing) {}
    std::size_t read(std::span<std::uint8_t> bytes) override;
    std::size_t write(std::span<const std::uint8_t> bytes) override;
    void maintain(Time) override {}
    [[nodiscard]] bool is_open() const override { return pipe_.connected_; }
    [[nodiscard]] std::string problem() const override;
    [[nodiscard]] const std::string& name() const override { return pipe_.name_; }

   private:
    const BytePipe& pipe_;
    Buffer& incoming_;
    Buffer& outgoing_;
  };

  std::string name_;
  bool connected_ = true;
  Buffer to_board_;
  Buffer to_robot_;
  End robot_end_{*this, to_robot_, to_board_};
  End board_end_{*this, to_board_, to_robot_};
};

}  // namespace galilean::robot
