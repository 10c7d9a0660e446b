// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <optional>

#include "core/device/comm_port.h"

namespace galilean::robot {

/// The comm_port as schemas see it: the real one, whose bumpers an operator or the referee can also
/// push.
class PushablePort final : public CommPort {
 public:
  static constexpr Duration kPush = std::chrono::milliseconds(300);

  explicit PushablePort(CommPort& port) : port_(port) {}

  /// Any thread. Presses bumper `index` from the next tick on, for `kPush`. An index without a
  /// bumper does nothing.
  void push(int index) noexcept;

  void sense(Time now) noexcept override;
  [[nodiscard]] bool healthy() const noexcept override { return port_.healthy(); }
  [[nodiscard]] std::string problem() const override { return port_.problem(); }
  [[nodiscard]] const ControllerStatus& status() const noexcept override { return status_; }
  void command_gripper(GripperCommand command) noexcept override {
    port_.command_gripper(command);
    gripper_ = command;
  }
  /// Returns the last order to the gripper since `sense`, if there was one.
  [[nodiscard]] std::optional<GripperCommand> gripper_order() const noexcept { return gripper_; }

 private:
  CommPort& port_;
  ControllerStatus status_;
  std::atomic<std::uint8_t> asked_{0};
  std::uint8_t pushed_ = 0;
  Time release_{};
  std::optional<GripperCommand> gripper_;
};

}  // namespace galilean::robot
