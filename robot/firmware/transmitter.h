// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "robot/firmware/messages.h"

namespace galilean::robot::firmware {

/// Frames that wait to be sent. A frame for which there is no room is dropped whole: half a frame
/// would be noise to the other side, and waiting would delay the speed loops.
class Transmitter {
 public:
  /// Returns the sequence that the frame got.
  template <class Message>
  std::uint16_t send(const Message& message) {
    std::array<std::uint8_t, kMaxEncoded> bytes;
    queue(std::span(bytes).first(encode_message(message, sequence_, bytes)));
    return sequence_++;
  }
  /// Calls `line` with bytes that wait. `line` returns how many of them it took.
  template <class Line>
  void flush(Line&& line) {
    if (length_ > 0) drop_first(line(std::span<const std::uint8_t>(waiting_).first(length_)));
  }

 private:
  void queue(std::span<const std::uint8_t> frame);
  void drop_first(std::size_t count);

  std::array<std::uint8_t, 256> waiting_{};
  std::size_t length_ = 0;
  std::uint16_t sequence_ = 0;
};

}  // namespace galilean::robot::firmware
