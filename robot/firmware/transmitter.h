#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "robot/firmware/hardware.h"
#include "robot/firmware/messages.h"

namespace galilean::robot::firmware {

/// Frames on their way out. A frame for which there is no room is left out whole: half a frame
/// would be noise to the other side, and waiting would hold up the speed loops.
class Transmitter {
 public:
  template <class Message>
  void send(const Message& message) {
    std::array<std::uint8_t, kMaxEncoded> bytes;
    queue(std::span(bytes).first(encode_message(message, sequence_++, bytes)));
  }
  /// Hands to the line what it will take.
  void flush(Hardware& hardware);

 private:
  void queue(std::span<const std::uint8_t> frame);

  std::array<std::uint8_t, 256> waiting_{};
  std::size_t length_ = 0;
  std::uint16_t sequence_ = 0;
};

}  // namespace galilean::robot::firmware
