// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/clock.h"
#include "robot/devices/boot_record.h"
#include "robot/devices/byte_stream.h"
#include "robot/firmware/messages.h"
#include "robot/firmware/protocol.h"
#include "robot/firmware/transmitter.h"

namespace galilean::robot {

/// The robot's side of docs/SERIAL_PROTOCOL.md. It runs in the I/O thread. It greets the board,
/// checks its version, and gives it its parameters and commands. It begins again whenever the line
/// or the board was lost.
///
///   closed → greeting → configuring → ready;   any → closed when the line is lost,
///   any → greeting when the board is silent or was reset
class BoardSession {
 public:
  BoardSession(ByteStream& line, Duration timeout);

  /// Reads from the line, answers, repeats what the board has not confirmed, and writes. Returns
  /// whether a status came.
  bool pump(Time now);
  /// Sets the parameters that the board works with from now on. No session becomes ready before the
  /// first call.
  void configure(const firmware::Parameters& parameters);

  /// Sets after how much silence the board counts as gone.
  void set_timeout(Duration timeout) noexcept { timeout_ = timeout; }

  /// Commands are dropped unless the session is ready: an old one must not move a robot later.
  void drive(const firmware::Drive& command);
  void stop();
  /// Orders the gripper to close or open. The order is repeated until the board carries it out,
  /// also after a reset of the board.
  void grip(bool close);

  [[nodiscard]] bool ready() const { return stage_ == Stage::kReady; }
  /// Returns the last status that came while the session was ready.
  [[nodiscard]] const firmware::Status& status() const { return status_; }
  /// Returns how often this side noticed a restart of the board.
  [[nodiscard]] std::uint32_t epoch() const { return boot_.epoch(); }
  /// Returns one sentence on why the session is not ready and what to do, or an empty text when it
  /// is ready.
  [[nodiscard]] std::string problem() const;

 private:
  enum class Stage { kClosed, kGreeting, kWrongVersion, kConfiguring, kRefused, kReady };

  void receive();
  void handle(const firmware::Frame& frame);
  void handle_reply(const firmware::Frame& frame);
  void handle_acknowledgement(const firmware::Frame& frame);
  void handle_status(const firmware::Frame& frame);
  void greet();
  void send_parameters();
  void close_session();
  void watch_silence();
  void repeat_unconfirmed();
  void repeat_commands();

  ByteStream& line_;
  Duration timeout_;
  Stage stage_ = Stage::kClosed;
  Time now_{};
  Time last_heard_{};
  Time last_repeat_{};
  firmware::FrameDecoder decoder_;
  firmware::Transmitter transmitter_;

  std::optional<firmware::Parameters> parameters_;
  std::optional<std::uint16_t> parameters_sent_as_;  ///< the sequence, until the board answers
  std::optional<bool> grip_closed_;
  bool stopping_ = false;

  firmware::Status status_;
  bool status_came_ = false;
  BootRecord boot_;
  unsigned other_version_ = 0;
};

}  // namespace galilean::robot
