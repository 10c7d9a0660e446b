// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <mutex>
#include <string>

#include "core/device/comm_port.h"
#include "core/latest.h"
#include "robot/devices/board_session.h"
#include "robot/devices/comm_port_settings.h"
#include "robot/devices/odometer.h"
#include "robot/firmware/messages.h"

namespace galilean::robot {

/// The part of a program's motor_drive that the board needs.
struct MotorSetup {
  firmware::Parameters parameters;
  double ticks_per_m = 325;
};

/// The comm_port of a robot: its microcontroller over a serial line. One I/O thread calls `pump`
/// and `fail` (the headless simulator calls `pump` between ticks). The control loop calls the other
/// methods. The two exchange their newest data through wait-free slots, so that neither waits for
/// the other.
class MicrocontrollerLink final : public CommPort {
 public:
  static constexpr Duration kTickPeriod = std::chrono::milliseconds(50);

  /// `tick_period` is that of the control loop: an order of a movement lasts little longer unless
  /// it is renewed.
  MicrocontrollerLink(ByteStream& line, const CommPortSettings& settings,
                      Duration tick_period = kTickPeriod);

  /// I/O side: reads and writes the line. Requires: it is called every few milliseconds.
  void pump(Time now);
  /// I/O side: reports that `pump` threw. The board counts as missing until `pump` succeeds again.
  void fail(const std::string& why);

  void sense(Time now) noexcept override;
  [[nodiscard]] bool healthy() const noexcept override { return healthy_; }
  [[nodiscard]] std::string problem() const override;
  [[nodiscard]] const ControllerStatus& status() const noexcept override;
  void command_gripper(GripperCommand command) noexcept override;

  /// Orders a movement, for motor_drive. Only the newest order of a tick reaches the board, and no
  /// order does while the board is away.
  void drive(const firmware::Drive& command) noexcept;
  /// Renews the movement that was ordered last, if nothing has stopped it.
  void keep_moving() noexcept;
  void stop() noexcept;
  void configure(const MotorSetup& setup) noexcept;
  /// Sets after how much silence the line counts as lost, for another program.
  void set_timeout(Duration timeout) noexcept;

 private:
  struct Order {
    bool stop = true;
    firmware::Drive drive;
    std::uint32_t number = 0;  ///< an order that is renewed keeps it
  };
  struct Report {
    bool ready = false;
    ControllerStatus status;
  };

  void forward_orders(Time now);
  void publish_report(Time now, bool status_came);
  void note_problem(std::string problem);

  Duration timeout_;
  Duration order_lasts_;
  std::string line_name_;
  BoardSession session_;
  Odometer odometer_;
  double counts_per_m_ = 0;
  Report newest_;
  Time last_pump_{};
  std::uint32_t forwarded_ = 0;  ///< number of the order that the session was given last
  Order ordered_;                ///< by the control loop

  Latest<Duration> new_timeout_;
  Latest<MotorSetup> setup_;
  Latest<Order> order_;
  Latest<GripperCommand> gripper_;
  Latest<Report> report_;

  bool healthy_ = false;
  std::atomic<bool> failed_{false};
  mutable std::mutex problem_mutex_;
  std::string problem_;
};

}  // namespace galilean::robot
