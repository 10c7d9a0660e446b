// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace galilean::robot::firmware {

/// It is raised whenever a message changes its meaning or its bytes. Both ends must have the same
/// version.
inline constexpr std::uint8_t kProtocolVersion = 2;

inline constexpr std::size_t kMaxPayload = 64;
/// Type, sequence and CRC around the payload.
inline constexpr std::size_t kFrameOverhead = 5;
inline constexpr std::size_t kMaxContent = kMaxPayload + kFrameOverhead;
/// Both delimiters and the one code byte that COBS adds to contents below 254 bytes.
inline constexpr std::size_t kMaxEncoded = kMaxContent + 3;

/// One message as it travels: see docs/SERIAL_PROTOCOL.md.
struct Frame {
  std::uint8_t type = 0;
  std::uint16_t sequence = 0;
  std::span<const std::uint8_t> payload;
};

/// Writes `frame` with CRC, COBS and a delimiter on both sides to `out`. Returns the number of
/// bytes written, or 0 if the payload is longer than kMaxPayload.
std::size_t encode(const Frame& frame, std::span<std::uint8_t, kMaxEncoded> out);

/// Finds frames in a stream of bytes. Bytes that are no frame are dropped up to the next delimiter.
/// One delimiter is therefore enough to be in step again.
class FrameDecoder {
 public:
  /// Takes the next byte. Returns whether it completed a frame, which `frame` returns until the
  /// next push.
  bool push(std::uint8_t byte);
  const Frame& frame() const { return frame_; }
  /// Drops the frame that is under way, because the line was lost.
  void restart() { started_ = false, too_long_ = false, left_in_block_ = 0, length_ = 0; }
  /// Returns the number of stretches between delimiters that were no frame: noise, or damaged
  /// frames.
  std::uint32_t rejected() const { return rejected_; }

 private:
  void append(std::uint8_t byte);
  bool finish();
  bool content_is_frame();

  std::array<std::uint8_t, kMaxContent> content_{};
  std::size_t length_ = 0;
  std::size_t left_in_block_ = 0;
  bool started_ = false;
  bool too_long_ = false;
  std::uint32_t rejected_ = 0;
  Frame frame_;
};

}  // namespace galilean::robot::firmware
