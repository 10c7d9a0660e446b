// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/board_session.h"

#include <array>

namespace galilean::robot {
namespace {

constexpr Duration kRepeat = std::chrono::milliseconds(100);
/// A board that confirms no command for so long does not read them, although it may send.
constexpr Duration kTakenWithin = std::chrono::milliseconds(500);

bool closes(std::uint8_t gripper_state) {
  const auto state = static_cast<firmware::GripperState>(gripper_state);
  return state == firmware::GripperState::kClosing || state == firmware::GripperState::kClosed;
}

}  // namespace

BoardSession::BoardSession(ByteStream& line, Duration timeout, Duration order_lasts)
    : line_(line), timeout_(timeout), order_lasts_(order_lasts) {}

bool BoardSession::pump(Time now) {
  now_ = now;
  status_came_ = false;
  line_.maintain(now);
  if (!line_.is_open()) {
    close_session();
    return false;
  }
  if (stage_ == Stage::kClosed) greet();
  receive();
  watch_silence();
  repeat_unconfirmed();
  send_motion();
  outbox_.flush([this](auto bytes) { return line_.write(bytes); });
  confirmation_.note_written(outbox_.last_command(), now);
  return status_came_;
}

void BoardSession::close_session() {
  stage_ = Stage::kClosed;
  decoder_.restart();
  outbox_.clear();
  motion_.reset();
}

void BoardSession::greet() {
  stage_ = Stage::kGreeting;
  stopping_ = false;
  // What was ordered in the session before must not move the robot in this one.
  motion_.reset();
  outbox_.drop_commands();
  confirmation_.reset();
  parameters_sent_as_.reset();
  last_heard_ = last_repeat_ = now_;
  outbox_.put(firmware::Hello{});
}

void BoardSession::receive() {
  std::array<std::uint8_t, 512> bytes;
  for (std::size_t count = line_.read(bytes); count > 0; count = line_.read(bytes))
    for (std::size_t i = 0; i < count; ++i)
      if (decoder_.push(bytes[i])) handle(decoder_.frame());
}

void BoardSession::handle(const firmware::Frame& frame) {
  switch (static_cast<firmware::MessageType>(frame.type)) {
    case firmware::MessageType::kHelloReply:
      return handle_reply(frame);
    case firmware::MessageType::kAcknowledgement:
      return handle_acknowledgement(frame);
    case firmware::MessageType::kStatus:
      return handle_status(frame);
    default:
      return;
  }
}

void BoardSession::handle_reply(const firmware::Frame& frame) {
  const bool asked = stage_ == Stage::kGreeting || stage_ == Stage::kWrongVersion;
  if (!asked || frame.payload.empty()) return;
  last_heard_ = now_;
  firmware::HelloReply reply;
  // The version stands first in the reply of every version of the protocol.
  if (frame.payload[0] != firmware::kProtocolVersion || !unpack(frame, reply)) {
    other_version_ = frame.payload[0];
    stage_ = Stage::kWrongVersion;
    return;
  }
  boot_.note_greeting(reply.name, reply.boot_count, reply.uptime_ms);
  stage_ = Stage::kConfiguring;
  send_parameters();
}

void BoardSession::configure(const firmware::Parameters& parameters) {
  parameters_ = parameters;
  if (stage_ == Stage::kRefused) stage_ = Stage::kConfiguring;
  if (stage_ == Stage::kConfiguring || ready()) send_parameters();
}

void BoardSession::send_parameters() {
  last_repeat_ = now_;
  if (parameters_) parameters_sent_as_ = outbox_.put(*parameters_);
}

void BoardSession::handle_acknowledgement(const firmware::Frame& frame) {
  firmware::Acknowledgement answer;
  if (!unpack(frame, answer)) return;
  const bool of_parameters =
      answer.message == static_cast<std::uint8_t>(firmware::MessageType::kParameters);
  if (!of_parameters || parameters_sent_as_ != answer.sequence) return;
  parameters_sent_as_.reset();
  const bool accepted = answer.result == static_cast<std::uint8_t>(firmware::Result::kAccepted);
  stage_ = accepted ? Stage::kReady : Stage::kRefused;
}

void BoardSession::handle_status(const firmware::Frame& frame) {
  firmware::Status status;
  if (!unpack(frame, status)) return;
  last_heard_ = now_;
  if (!ready()) return;
  if (boot_.differs(status.boot_count, status.uptime_ms)) return greet();
  boot_.note(status.boot_count, status.uptime_ms);
  confirmation_.note_accepted(status.last_command);
  status_ = status;
  status_came_ = true;
}

void BoardSession::watch_silence() {
  const bool silent = now_ - last_heard_ > timeout_;
  if (ready() && (silent || confirmation_.missing_for(kTakenWithin, now_))) greet();
}

void BoardSession::repeat_unconfirmed() {
  if (now_ - last_repeat_ < kRepeat) return;
  last_repeat_ = now_;
  if (stage_ == Stage::kGreeting || stage_ == Stage::kWrongVersion)
    outbox_.put(firmware::Hello{});
  else if (stage_ == Stage::kConfiguring || parameters_sent_as_)
    send_parameters();
  else if (ready())
    repeat_commands();
}

void BoardSession::repeat_commands() {
  if (grip_closed_ && *grip_closed_ != closes(status_.gripper_state)) grip(*grip_closed_);
  const bool active = (status_.flags & firmware::status_flag::kMotorsActive) != 0;
  if (stopping_ && (active || confirmation_.missing())) stop();
}

void BoardSession::drive(const firmware::Drive& command, Time now) {
  if (!ready()) return;
  stopping_ = false;
  motion_ = Motion{command, outbox_.take_sequence(), false};
  motion_ordered_ = now;
}

void BoardSession::keep_moving(Time now) {
  motion_ordered_ = now;
}

void BoardSession::send_motion() {
  const bool blocked = confirmation_.missing_for(kConfirmedWithin, now_);
  if (!ready() || !motion_ || blocked) return;
  const bool wanted = now_ - motion_ordered_ <= order_lasts_;
  const bool due = !motion_->sent || now_ - motion_sent_ >= kDrivePause;
  if (!wanted || !due) return;
  outbox_.put_again(motion_->command, motion_->sequence);
  motion_->sent = true;
  motion_sent_ = now_;
}

void BoardSession::stop() {
  motion_.reset();
  if (!ready()) return;
  stopping_ = true;
  outbox_.put(firmware::Stop{});
}

void BoardSession::grip(bool close) {
  grip_closed_ = close;
  if (ready()) outbox_.put(firmware::Gripper{static_cast<std::uint8_t>(close)});
}

std::string BoardSession::problem() const {
  const std::string board = "The microcontroller on " + line_.name();
  switch (stage_) {
    case Stage::kClosed:
      return line_.problem();
    case Stage::kGreeting:
      return board + " does not answer: check its power and its cable.";
    case Stage::kWrongVersion:
      return board + " speaks version " + std::to_string(other_version_) +
             " of the serial protocol and this robot version " +
             std::to_string(firmware::kProtocolVersion) + ": give it this release's firmware.";
    case Stage::kConfiguring:
      return board + (parameters_ ? " is being given its parameters."
                                  : " waits for a program to give it parameters.");
    case Stage::kRefused:
      return board + " refuses the parameters of motor_drive: bring them within its limits.";
    case Stage::kReady:
      break;
  }
  return "";
}

}  // namespace galilean::robot
