// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "robot/firmware/messages.h"

namespace galilean::robot {

/// What a robot has still to tell its board. It has one place for each type of message, so that a
/// newer message replaces an older one that was not written yet, however long the line takes
/// nothing. A stop also replaces a drive, and a drive a stop. A stop is written first, a drive
/// last. A frame of which the line took a part is always finished: half a frame would be noise.
class CommandOutbox {
 public:
  /// Returns the sequence that the message got.
  template <class Message>
  std::uint16_t put(const Message& message) {
    const std::uint16_t sequence = take_sequence();
    put_again(message, sequence);
    return sequence;
  }
  /// Returns a sequence for a message that is put later.
  [[nodiscard]] std::uint16_t take_sequence() { return next_sequence_++; }
  /// Puts a message with the sequence that it got before.
  template <class Message>
  void put_again(const Message& message, std::uint16_t sequence) {
    Frame& frame = replaced(Message::kType);
    frame.sequence = sequence;
    frame.length = firmware::encode_message(message, sequence, frame.bytes);
  }

  /// Calls `line` with bytes that wait, until it takes no more. `line` returns how many of them it
  /// took.
  template <class Line>
  void flush(Line&& line) {
    for (Frame* frame = next(); frame != nullptr; frame = next()) {
      const auto bytes = std::span<const std::uint8_t>(frame->bytes);
      const std::size_t taken = line(bytes.subspan(written_, frame->length - written_));
      if (taken == 0) return;
      note_taken(*frame, taken);
    }
  }

  /// Drops the messages that move the robot: what was ordered in an earlier session.
  void drop_commands();
  /// Drops all, because the line was lost.
  void clear();
  /// Returns the sequence of the Drive, Stop or Gripper that was written last since
  /// `drop_commands`.
  [[nodiscard]] std::optional<std::uint16_t> last_command() const { return last_command_; }

 private:
  struct Frame {
    std::array<std::uint8_t, firmware::kMaxEncoded> bytes{};
    std::size_t length = 0;  ///< 0: the place is empty
    std::uint16_t sequence = 0;
    bool is_command = false;
  };
  /// The places, in the order in which they are written.
  enum Place : std::uint8_t { kStop, kHello, kParameters, kGripper, kDrive, kPlaces };

  [[nodiscard]] static Place place_of(firmware::MessageType type);
  [[nodiscard]] Frame& replaced(firmware::MessageType type);
  [[nodiscard]] Frame* next();
  void note_taken(Frame& frame, std::size_t taken);

  std::array<Frame, kPlaces> waiting_{};
  Frame under_way_;          ///< the frame of which the line took a part
  std::size_t written_ = 0;  ///< how much of `under_way_`
  std::uint16_t next_sequence_ = 0;
  std::optional<std::uint16_t> last_command_;
};

}  // namespace galilean::robot
