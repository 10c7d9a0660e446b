// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

#include "core/wire/reader.h"
#include "core/worker.h"
#include "robot/telemetry/publisher.h"

namespace galilean::robot {

/// Carries out the operators' commands: hold, resume, push a bumper, commission and decommission. A
/// command takes effect in the next tick.
class CommandReceiver {
 public:
  /// Errors: throws std::runtime_error if DDS refuses the topic.
  CommandReceiver(const TelemetrySource& source, const Worker::Report& report);

 private:
  void take();
  void obey(const msg::Command& command);

  TelemetrySource source_;
  std::mutex taking_;
  wire::Reader reader_;
};

}  // namespace galilean::robot
