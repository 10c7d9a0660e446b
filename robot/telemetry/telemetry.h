// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/log/log_queue.h"
#include "robot/telemetry/command_receiver.h"
#include "robot/telemetry/image_publisher.h"
#include "robot/telemetry/program_receiver.h"
#include "robot/telemetry/publisher.h"
#include "robot/telemetry/thread_problems.h"

namespace galilean::robot {

/// All that connects a robot with the DDS domain. The control loop does not depend on it: the loop
/// may run before this object is made and after it is destroyed.
class Telemetry {
 public:
  /// Errors: throws std::runtime_error if DDS refuses a topic.
  Telemetry(const TelemetrySource& source, ImageTap& images)
      : log_forwarding_(log_),
        programs_(source, problems_.reporter("program_receiver")),
        publisher_(source, log_, problems_,
                   [this](const Event& event) { programs_.on_event(event); }),
        images_(source, images, problems_.reporter("image_publisher")),
        commands_(source, problems_.reporter("command_receiver")) {}

  /// Returns where other threads enter their problems, so that these are published too.
  [[nodiscard]] ThreadProblems& problems() noexcept { return problems_; }

 private:
  ThreadProblems problems_;
  LogQueue log_;
  LogForwarding log_forwarding_;
  ProgramReceiver programs_;
  Publisher publisher_;
  ImagePublisher images_;
  CommandReceiver commands_;
};

}  // namespace galilean::robot
