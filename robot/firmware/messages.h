#pragma once

#include <array>
#include <cstdint>

#include "robot/firmware/payload.h"
#include "robot/firmware/protocol.h"

namespace galilean::robot::firmware {

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

/// Robot to board: opens a session.
struct Hello {
  static constexpr auto kType = MessageType::kHello;
  std::uint8_t version = kProtocolVersion;

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.version);
  }
};

/// Board to robot: who it is. `boot_count` and `uptime_ms` tell a board that was reset.
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

/// PWM below which a motor does not move, signed as it is applied.
struct DeadZones {
  std::int16_t left_forward = 0;
  std::int16_t right_forward = 0;
  std::int16_t left_reverse = 0;
  std::int16_t right_reverse = 0;

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.left_forward), io(m.right_forward), io(m.left_reverse), io(m.right_reverse);
  }
};

/// Robot to board: what its program says of the motors. Until it came the motors do not move.
struct Parameters {
  static constexpr auto kType = MessageType::kParameters;
  float proportional_gain = 0;         ///< PWM per tick/s of speed error
  float integral_gain = 0;             ///< PWM per tick of summed speed error
  float derivative_gain = 0;           ///< PWM per tick/s² of measured acceleration
  float feedforward_gain = 0;          ///< PWM per tick/s of wanted speed, above the dead zone
  DeadZones straight_dead_zones;       ///< both treads run the same way
  DeadZones turn_dead_zones;           ///< in-place turn: the treads scrub
  float forward_velocity_ticks_s = 0;  ///< fastest that a wheel may go
  float turning_velocity_ticks_s = 0;  ///< fastest that a wheel may go in an in-place turn
  float acceleration_ticks_s2 = 0;
  std::uint32_t timeout_ms = 0;  ///< the motors stop when no Drive came for so long

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.proportional_gain), io(m.integral_gain), io(m.derivative_gain), io(m.feedforward_gain);
    DeadZones::fields(m.straight_dead_zones, io);
    DeadZones::fields(m.turn_dead_zones, io);
    io(m.forward_velocity_ticks_s), io(m.turning_velocity_ticks_s), io(m.acceleration_ticks_s2);
    io(m.timeout_ms);
  }
};

/// Robot to board: replaces the motion under way; speeds ramp from what they are now.
struct Drive {
  static constexpr auto kType = MessageType::kDrive;
  std::int16_t left_speed_counts_s = 0;   ///< forward positive; 16 counts are a tick
  std::int16_t right_speed_counts_s = 0;  ///< forward positive
  std::uint32_t left_limit_counts = 0;    ///< travel after which the wheel stands; 0: no limit
  std::uint32_t right_limit_counts = 0;   ///< travel after which the wheel stands; 0: no limit

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.left_speed_counts_s), io(m.right_speed_counts_s);
    io(m.left_limit_counts), io(m.right_limit_counts);
  }
};

/// Robot to board: cuts both motors at once, without a ramp.
struct Stop {
  static constexpr auto kType = MessageType::kStop;

  template <class Self, class Io>
  static constexpr void fields(Self&, Io&) {}
};

struct Gripper {
  static constexpr auto kType = MessageType::kGripper;
  std::uint8_t close = 0;  ///< 1 closes, 0 opens

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.close);
  }
};

/// Robot to board: asks for a Status now, besides those that come by themselves.
struct StatusRequest {
  static constexpr auto kType = MessageType::kStatusRequest;

  template <class Self, class Io>
  static constexpr void fields(Self&, Io&) {}
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
  std::uint16_t sequence = 0;  ///< its sequence
  std::uint8_t result = 0;     ///< a Result

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.message), io(m.sequence), io(m.result);
  }
};

enum class GripperState : std::uint8_t { kOpen = 0, kClosing = 1, kClosed = 2, kOpening = 3 };

namespace status_flag {
inline constexpr std::uint8_t kStoppedByTimeout = 1 << 0;  ///< until the next Drive
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
  std::uint16_t rejected_frames = 0;  ///< damaged frames that the board heard since its start

  template <class Self, class Io>
  static constexpr void fields(Self& m, Io& io) {
    io(m.uptime_ms), io(m.boot_count), io(m.last_command);
    io(m.left_encoder_counts), io(m.right_encoder_counts);
    io(m.left_speed_counts_s), io(m.right_speed_counts_s);
    io(m.bumpers), io(m.gripper_state), io(m.gripper_percent), io(m.flags), io(m.rejected_frames);
  }
};

/// Encodes a message whole; the number of bytes written.
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

/// Reads the frame's payload; false if its length is not this message's, and `message` is as it
/// was.
template <class Message>
bool unpack(const Frame& frame, Message& message) {
  if (frame.payload.size() != payload_size<Message>()) return false;
  PayloadReader reader(frame.payload);
  Message::fields(message, reader);
  return true;
}

}  // namespace galilean::robot::firmware
