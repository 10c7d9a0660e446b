// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "core/wire/writer.h"
#include "core/worker.h"
#include "robot/inputs/compose_inputs.h"
#include "robot/telemetry/publisher.h"
#include "robot/telemetry/wall_time.h"

namespace galilean::robot {

/// Publishes what each tick read from outside and what it led to, while somebody reads it. It works
/// in a thread of its own, which alone waits for slow readers. The first ticks after the start are
/// kept for some seconds: a recorder that ran before the robot connects meanwhile, and so gets the
/// run from its first tick on.
class InputsPublisher {
 public:
  /// Errors: throws std::runtime_error if DDS refuses the topic.
  InputsPublisher(const TelemetrySource& source, InputsTap& tap, Worker::Report report);

 private:
  void look();
  void collect();
  void send();
  void forget();

  InputsTap& tap_;
  const Clock& clock_;
  const Time began_;
  WallTime wall_;
  InputsComposer compose_;
  wire::Writer<msg::TickInputs> writer_;
  std::deque<msg::TickInputs> waiting_;
  std::size_t waiting_bytes_ = 0;
  Worker worker_;
};

}  // namespace galilean::robot
