// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/clock.h"
#include "robot/devices/boot_record.h"
#include "robot/devices/byte_stream.h"
#include "robot/devices/command_confirmation.h"
#include "robot/devices/command_outbox.h"
#include "robot/firmware/messages.h"
#include "robot/firmware/protocol.h"

namespace galilean::robot {

/// The robot's side of docs/SERIAL_PROTOCOL.md. It runs in the I/O thread. It greets the board,
/// checks its version, and gives it its parameters and commands. It begins again whenever the line
/// or the board was lost.
///
///   closed → greeting → configuring → ready;   any → closed when the line is lost,
///   any → greeting when the board is silent, takes no commands, or was reset
///
/// A movement is sent again every kDrivePause, with the same sequence, as long as it was ordered or
/// renewed in the last `order_lasts`: a lost frame is not felt, and a control loop that hangs stops
/// the motors. While the board has not confirmed a command for kConfirmedWithin, no movement is
/// sent: no more than that is on its way ahead of a stop, whatever the line does with it.
class BoardSession {
 public:
  static constexpr Duration kDrivePause = std::chrono::milliseconds(15);
  static constexpr Duration kConfirmedWithin = std::chrono::milliseconds(60);

  BoardSession(ByteStream& line, Duration timeout, Duration order_lasts);

  /// Reads from the line, answers, repeats what the board has not confirmed, and writes. Returns
  /// whether a status came.
  bool pump(Time now);
  /// Sets the parameters that the board works with from now on. No session becomes ready before the
  /// first call.
  void configure(const firmware::Parameters& parameters);

  /// Sets after how much silence the board counts as gone.
  void set_timeout(Duration timeout) noexcept { timeout_ = timeout; }

  /// Commands are dropped unless the session is ready: an old one must not move a robot later.
  void drive(const firmware::Drive& command, Time now);
  /// Renews the movement that was ordered last, if there is one.
  void keep_moving(Time now);
  void stop();
  /// Orders the gripper to close or open. The order is repeated until the board carries it out,
  /// also after a reset of the board.
  void grip(bool close);

  [[nodiscard]] bool ready() const { return stage_ == Stage::kReady; }
  /// Returns the last status that came while the session was ready.
  [[nodiscard]] const firmware::Status& status() const { return status_; }
  /// Returns how often this side noticed that the board was restarted or is another one.
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
  void send_motion();

  ByteStream& line_;
  Duration timeout_;
  Duration order_lasts_;
  Stage stage_ = Stage::kClosed;
  Time now_{};
  Time last_heard_{};
  Time last_repeat_{};
  firmware::FrameDecoder decoder_;
  CommandOutbox outbox_;

  std::optional<firmware::Parameters> parameters_;
  std::optional<std::uint16_t> parameters_sent_as_;  ///< the sequence, until the board answers
  std::optional<bool> grip_closed_;
  bool stopping_ = false;

  struct Motion {
    firmware::Drive command;
    std::uint16_t sequence = 0;
    bool sent = false;
  };
  std::optional<Motion> motion_;  ///< the movement that is wanted
  Time motion_ordered_{};
  Time motion_sent_{};
  CommandConfirmation confirmation_;

  firmware::Status status_;
  bool status_came_ = false;
  BootRecord boot_;
  unsigned other_version_ = 0;
};

}  // namespace galilean::robot
