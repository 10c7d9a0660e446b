// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/device/motor_drive.h"
#include "core/memory.h"

namespace galilean::robot {

/// What the motors were ordered in one tick.
struct MotionOrders {
  std::uint32_t count = 0;  ///< 0: nothing, and the order before stays in force
  bool stop = false;        ///< whether the last of them is to stop
  DriveCommand last;        ///< the last one if it is to drive; else of no meaning
};

/// Passes the commands of the schemas on to the motors, and stops the motors when no schema may
/// drive or none does. That is the case while somebody or a fault holds the robot or a device is
/// missing, when the program enters a state whose schemas do not drive, and when no schema has
/// driven for the timeout. Within the timeout it renews the last command in every tick, because the
/// board stops the motors soon after it hears nothing.
class GuardedDrive final : public MotorDrive {
 public:
  explicit GuardedDrive(MotorDrive& motors) : motors_(motors) {}

  void set_timeout(Duration timeout) noexcept { timeout_ = timeout; }
  /// Is called before the motor schemas run. `free` tells whether they may drive.
  void begin(Time now, bool free) noexcept;
  /// Is called after the motor schemas ran.
  void finish(bool state_changed) noexcept;
  void keep(Memory& memory) noexcept {
    memory.keep(timeout_);
    memory.keep(last_command_);
    memory.keep(driving_);
  }
  /// Returns what the motors were ordered since `begin`.
  [[nodiscard]] const MotionOrders& orders() const noexcept { return orders_; }

  void sense(Time now) noexcept override { motors_.sense(now); }
  [[nodiscard]] bool healthy() const noexcept override { return motors_.healthy(); }
  [[nodiscard]] std::string problem() const override { return motors_.problem(); }
  void drive(const DriveCommand& command) noexcept override;
  void stop() noexcept override;
  [[nodiscard]] double forward_speed_mps() const noexcept override {
    return motors_.forward_speed_mps();
  }
  [[nodiscard]] double turning_speed_radps() const noexcept override {
    return motors_.turning_speed_radps();
  }
  [[nodiscard]] double turn_radius_m() const noexcept override { return motors_.turn_radius_m(); }

 private:
  MotorDrive& motors_;
  Duration timeout_ = std::chrono::milliseconds(500);
  Time now_{};
  Time last_command_{};
  bool free_ = false;
  bool commanded_ = false;  ///< in this tick
  bool driving_ = false;    ///< a command may still be in force
  MotionOrders orders_;
};

}  // namespace galilean::robot
