// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "robot/firmware/message_type.h"
#include "robot/firmware/protocol.h"

namespace galilean::robot::firmware {

/// Board to robot: who it is. `boot_count` and `uptime_ms` show that a board was reset.
struct HelloReply {
  static constexpr auto kType = MessageType::kHelloReply;
  std::uint8_t version = kProtocolVersion;
  std::array<std::uint8_t, 3> firmware_version{};  ///< major, minor, patch
  std::uint16_t boot_count = 0;
  std::uint32_t uptime_ms = 0;
  std::array<std::uint8_t, 16> name{};  ///< ASCII, filled up with zeros

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.version), io(m.firmware_version), io(m.boot_count), io(m.uptime_ms), io(m.name);
  }
};

enum class Result : std::uint8_t {
  kAccepted = 0,
  kUnknownMessage = 1,
  kMalformed = 2,     ///< the payload has not this message's length
  kWrongVersion = 3,  ///< Hello named another version of the protocol
  kOutOfRange = 4,    ///< a value that the board cannot work with; nothing was changed
  kNoParameters = 5,  ///< Drive before Parameters
};

/// Board to robot: answers Parameters, and any message that was refused.
struct Acknowledgement {
  static constexpr auto kType = MessageType::kAcknowledgement;
  std::uint8_t message = 0;    ///< type of the message answered
  std::uint16_t sequence = 0;  ///< the sequence of that message
  std::uint8_t result = 0;     ///< a Result

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.message), io(m.sequence), io(m.result);
  }
};

enum class GripperState : std::uint8_t { kOpen = 0, kClosing = 1, kClosed = 2, kOpening = 3 };

namespace status_flag {
inline constexpr std::uint8_t kStoppedByTimeout = 1 << 0;  ///< by a timer, until Drive
inline constexpr std::uint8_t kParametersReceived = 1 << 1;
inline constexpr std::uint8_t kMotorsActive = 1 << 2;
inline constexpr std::uint8_t kBeamBroken = 1 << 3;
}  // namespace status_flag

/// Board to robot, 50 times a second: all that the board knows.
struct Status {
  static constexpr auto kType = MessageType::kStatus;
  std::uint32_t uptime_ms = 0;
  std::uint16_t boot_count = 0;
  std::uint16_t last_command = 0;  ///< sequence of the newest command that was accepted
  std::int32_t left_encoder_counts = 0;
  std::int32_t right_encoder_counts = 0;
  std::int16_t left_speed_counts_s = 0;
  std::int16_t right_speed_counts_s = 0;
  std::uint8_t bumpers = 0;           ///< bit n: switch n is pressed
  std::uint8_t gripper_state = 0;     ///< a GripperState
  std::uint8_t gripper_percent = 0;   ///< 0 open … 100 closed
  std::uint8_t flags = 0;             ///< status_flag
  std::uint16_t rejected_frames = 0;  ///< damaged frames that the board received since its start

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.uptime_ms), io(m.boot_count), io(m.last_command);
    io(m.left_encoder_counts), io(m.right_encoder_counts);
    io(m.left_speed_counts_s), io(m.right_speed_counts_s);
    io(m.bumpers), io(m.gripper_state), io(m.gripper_percent), io(m.flags), io(m.rejected_frames);
  }
};

}  // namespace galilean::robot::firmware
