// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "robot/firmware/messages.h"

namespace galilean::robot::firmware {

/// Frames on their way out. A frame for which there is no room is left out whole: half a frame
/// would be noise to the other side, and waiting would hold up the speed loops.
class Transmitter {
 public:
  /// The sequence that the frame got.
  template <class Message>
  std::uint16_t send(const Message& message) {
    std::array<std::uint8_t, kMaxEncoded> bytes;
    queue(std::span(bytes).first(encode_message(message, sequence_, bytes)));
    return sequence_++;
  }
  /// Hands to `line` what it will take: it is called with bytes, and returns how many it took.
  template <class Line>
  void flush(Line&& line) {
    if (length_ > 0) drop_first(line(std::span<const std::uint8_t>(waiting_).first(length_)));
  }
  /// Forgets what waits: the line was lost.
  void clear() { length_ = 0; }

 private:
  void queue(std::span<const std::uint8_t> frame);
  void drop_first(std::size_t count);

  std::array<std::uint8_t, 256> waiting_{};
  std::size_t length_ = 0;
  std::uint16_t sequence_ = 0;
};

}  // namespace galilean::robot::firmware
