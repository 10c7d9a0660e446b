// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "robot/telemetry/break_desk.h"
#include "robot/telemetry/order_gate.h"
#include "robot/telemetry/order_reader.h"
#include "robot/telemetry/publisher.h"

namespace galilean::robot {

/// Carries out the operators' commands: hold, resume, step, push a bumper, commission and
/// decommission. A command takes effect in the next tick.
class CommandReceiver {
 public:
  /// Requires: `desk` and `gate` outlive this.
  /// Errors: throws std::runtime_error if DDS refuses the topic.
  CommandReceiver(const TelemetrySource& source, BreakDesk& desk, OrderGate& gate,
                  const Worker::Report& report);

 private:
  [[nodiscard]] bool admit(const msg::Command& command, OrderGate::Origin origin);
  void obey(const msg::Command& command);
  void push_bumper(const msg::Command& command);

  Executive& executive_;
  BreakDesk& desk_;
  OrderGate& gate_;
  const std::string place_;
  OrderReader<msg::Command> commands_;
};

}  // namespace galilean::robot
