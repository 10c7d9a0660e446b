// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/protocol.h"

#include "robot/firmware/crc.h"

namespace galilean::robot::firmware {
namespace {

constexpr std::uint8_t kDelimiter = 0;
constexpr std::size_t kHeaderBytes = 3;
constexpr std::size_t kCrcBytes = 2;

std::uint8_t low_byte(std::uint16_t value) {
  return static_cast<std::uint8_t>(value & 0xFF);
}
std::uint8_t high_byte(std::uint16_t value) {
  return static_cast<std::uint8_t>(value >> 8);
}
std::uint16_t word(std::uint8_t low, std::uint8_t high) {
  return static_cast<std::uint16_t>(low | (high << 8));
}

std::size_t write_content(const Frame& frame, std::array<std::uint8_t, kMaxContent>& content) {
  std::size_t length = 0;
  content[length++] = frame.type;
  content[length++] = low_byte(frame.sequence);
  content[length++] = high_byte(frame.sequence);
  for (const std::uint8_t byte : frame.payload) content[length++] = byte;
  const std::uint16_t crc = crc16(std::span(content).first(length));
  content[length++] = low_byte(crc);
  content[length++] = high_byte(crc);
  return length;
}

/// Encodes by consistent overhead byte stuffing (Cheshire and Baker 1999): each zero becomes the
/// distance to the next one.
std::size_t stuff(std::span<const std::uint8_t> content, std::span<std::uint8_t> out) {
  std::size_t code_at = 0;
  std::size_t length = 1;
  for (const std::uint8_t byte : content) {
    if (byte != kDelimiter) {
      out[length++] = byte;
      continue;
    }
    out[code_at] = static_cast<std::uint8_t>(length - code_at);
    code_at = length++;
  }
  out[code_at] = static_cast<std::uint8_t>(length - code_at);
  return length;
}

}  // namespace

std::size_t encode(const Frame& frame, std::span<std::uint8_t, kMaxEncoded> out) {
  if (frame.payload.size() > kMaxPayload) return 0;
  std::array<std::uint8_t, kMaxContent> content;
  const std::size_t length = write_content(frame, content);
  out[0] = kDelimiter;
  const std::size_t stuffed = stuff(std::span(content).first(length), out.subspan(1));
  out[1 + stuffed] = kDelimiter;
  return stuffed + 2;
}

bool FrameDecoder::push(std::uint8_t byte) {
  if (byte == kDelimiter) return finish();
  if (left_in_block_ > 0) {
    --left_in_block_;
    append(byte);
    return false;
  }
  if (started_) append(kDelimiter);
  started_ = true;
  left_in_block_ = byte - 1u;
  return false;
}

void FrameDecoder::append(std::uint8_t byte) {
  if (length_ < content_.size())
    content_[length_++] = byte;
  else
    too_long_ = true;
}

bool FrameDecoder::finish() {
  const bool complete = started_ && left_in_block_ == 0 && !too_long_ && content_is_frame();
  if (started_ && !complete) ++rejected_;
  restart();
  return complete;
}

bool FrameDecoder::content_is_frame() {
  if (length_ < kFrameOverhead) return false;
  const auto content = std::span<const std::uint8_t>(content_).first(length_);
  const auto checked = content.first(length_ - kCrcBytes);
  if (crc16(checked) != word(content[length_ - 2], content[length_ - 1])) return false;
  frame_ = {content[0], word(content[1], content[2]), checked.subspan(kHeaderBytes)};
  return true;
}

}  // namespace galilean::robot::firmware
