// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace galilean::robot::firmware {

/// First byte of a frame. The board sends the types from 0x80 on.
enum class MessageType : std::uint8_t {
  kHello = 0x01,
  kParameters = 0x02,
  kDrive = 0x03,
  kStop = 0x04,
  kGripper = 0x05,
  kStatusRequest = 0x06,
  kHelloReply = 0x81,
  kAcknowledgement = 0x82,
  kStatus = 0x83,
};

}  // namespace galilean::robot::firmware
