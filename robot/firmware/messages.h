// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "robot/firmware/commands.h"
#include "robot/firmware/payload.h"
#include "robot/firmware/protocol.h"
#include "robot/firmware/reports.h"

namespace galilean::robot::firmware {

/// Encodes a whole message. Returns the number of bytes written.
template <class Message>
std::size_t encode_message(const Message& message, std::uint16_t sequence,
                           std::span<std::uint8_t, kMaxEncoded> out) {
  static_assert(payload_size<Message>() <= kMaxPayload);
  std::array<std::uint8_t, kMaxPayload> payload;
  PayloadWriter writer(payload);
  Message::fields(message, writer);
  const auto used = std::span<const std::uint8_t>(payload).first(payload_size<Message>());
  return encode({static_cast<std::uint8_t>(Message::kType), sequence, used}, out);
}

/// Decodes the payload of a frame. Returns false, and leaves `message` as it was, if the length is
/// not that of this message.
template <class Message>
bool unpack(const Frame& frame, Message& message) {
  if (frame.payload.size() != payload_size<Message>()) return false;
  PayloadReader reader(frame.payload);
  Message::fields(message, reader);
  return true;
}

}  // namespace galilean::robot::firmware
