// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/controller.h"

#include <algorithm>
#include <cmath>

namespace galilean::robot::firmware {
namespace {

constexpr std::size_t kBeam = 8;
/// The most bytes that one update takes from the line. At 115200 baud about 23 bytes come in 2 ms.
constexpr std::size_t kReceiveAtOnce = 128;

std::int16_t rounded(float value) {
  return static_cast<std::int16_t>(std::clamp(std::round(value), -32767.0f, 32767.0f));
}

bool is_command(MessageType type) {
  return type == MessageType::kDrive || type == MessageType::kStop || type == MessageType::kGripper;
}

}  // namespace

Controller::Controller(Hardware& hardware, const Identity& identity)
    : hardware_(hardware), identity_(identity), inputs_(hardware.read()) {
  drive_train_.start_at(inputs_, now_ms_);
}

void Controller::update(std::uint32_t now_ms) {
  now_ms_ = now_ms;
  receive();
  if (now_ms_ - last_control_ms_ >= kPeriod_ms) control();
  if (now_ms_ - last_status_ms_ >= kStatusPeriod_ms) send_status();
  transmitter_.flush([this](auto bytes) { return hardware_.send(bytes); });
}

void Controller::receive() {
  std::array<std::uint8_t, kReceiveAtOnce> bytes;
  const std::size_t count = hardware_.receive(bytes);
  for (std::size_t i = 0; i < count; ++i)
    if (decoder_.push(bytes[i])) handle(decoder_.frame());
}

void Controller::handle(const Frame& frame) {
  const Result result = obey(frame);
  const auto type = static_cast<MessageType>(frame.type);
  if (result == Result::kAccepted && is_command(type)) last_command_ = frame.sequence;
  if (result != Result::kAccepted || type == MessageType::kParameters)
    transmitter_.send(
        Acknowledgement{frame.type, frame.sequence, static_cast<std::uint8_t>(result)});
}

Result Controller::obey(const Frame& frame) {
  switch (static_cast<MessageType>(frame.type)) {
    case MessageType::kHello:
      return greet(frame);
    case MessageType::kParameters:
      return configure(frame);
    case MessageType::kDrive:
      return drive(frame);
    case MessageType::kStop:
      return stop(frame);
    case MessageType::kGripper:
      return grip(frame);
    case MessageType::kStatusRequest:
      return report(frame);
    default:
      return Result::kUnknownMessage;
  }
}

Result Controller::greet(const Frame& frame) {
  Hello hello;
  if (!unpack(frame, hello)) return Result::kMalformed;
  // What an earlier session ordered must not move the robot in this one.
  stop_motion();
  transmitter_.send(HelloReply{kProtocolVersion, kFirmwareVersion, identity_.boot_count, now_ms_,
                               identity_.name});
  return hello.version == kProtocolVersion ? Result::kAccepted : Result::kWrongVersion;
}

Result Controller::configure(const Frame& frame) {
  Parameters parameters;
  if (!unpack(frame, parameters)) return Result::kMalformed;
  return drive_train_.set(parameters) ? Result::kAccepted : Result::kOutOfRange;
}

Result Controller::drive(const Frame& frame) {
  Drive command;
  if (!unpack(frame, command)) return Result::kMalformed;
  if (!drive_train_.configured()) return Result::kNoParameters;
  // The same Drive once more goes on with its motion: the limits do not begin anew.
  if (motion_ == frame.sequence) {
    drive_train_.keep_driving(now_ms_);
  } else {
    drive_train_.drive(command, now_ms_);
    motion_ = frame.sequence;
  }
  return Result::kAccepted;
}

Result Controller::stop(const Frame& frame) {
  Stop command;
  if (!unpack(frame, command)) return Result::kMalformed;
  stop_motion();
  return Result::kAccepted;
}

void Controller::stop_motion() {
  drive_train_.brake();
  motion_.reset();
}

Result Controller::grip(const Frame& frame) {
  Gripper command;
  if (!unpack(frame, command)) return Result::kMalformed;
  if (command.close > 1) return Result::kOutOfRange;
  command.close ? gripper_.close() : gripper_.open();
  return Result::kAccepted;
}

Result Controller::report(const Frame& frame) {
  StatusRequest request;
  if (!unpack(frame, request)) return Result::kMalformed;
  send_status();
  return Result::kAccepted;
}

void Controller::control() {
  // After a longer break profiles and servo go on from where they stood, without a jump.
  const std::uint32_t elapsed_ms = std::min(now_ms_ - last_control_ms_, kLongestStep_ms);
  last_control_ms_ = now_ms_;
  inputs_ = hardware_.read();
  const auto bits = static_cast<std::uint16_t>(inputs_.bumpers | (inputs_.beam_broken << kBeam));
  switches_on_ = switches_.step(bits, now_ms_);
  drive_train_.step(inputs_, now_ms_, static_cast<float>(elapsed_ms) / 1000, outputs_);
  outputs_.gripper_permille = gripper_.step(static_cast<std::int32_t>(elapsed_ms));
  hardware_.write(outputs_);
}

void Controller::send_status() {
  last_status_ms_ = now_ms_;
  Status status;
  status.uptime_ms = now_ms_;
  status.boot_count = identity_.boot_count;
  status.last_command = last_command_;
  status.left_encoder_counts = inputs_.left_encoder_counts;
  status.right_encoder_counts = inputs_.right_encoder_counts;
  status.left_speed_counts_s = rounded(drive_train_.left_speed_counts_s());
  status.right_speed_counts_s = rounded(drive_train_.right_speed_counts_s());
  status.bumpers = static_cast<std::uint8_t>(switches_on_);
  status.gripper_state = static_cast<std::uint8_t>(gripper_.state());
  status.gripper_percent = gripper_.percent();
  if (switches_on_ >> kBeam) status.flags |= status_flag::kBeamBroken;
  if (drive_train_.configured()) status.flags |= status_flag::kParametersReceived;
  if (drive_train_.active()) status.flags |= status_flag::kMotorsActive;
  if (drive_train_.stopped_by_timeout()) status.flags |= status_flag::kStoppedByTimeout;
  status.rejected_frames = static_cast<std::uint16_t>(decoder_.rejected());
  transmitter_.send(status);
}

}  // namespace galilean::robot::firmware
