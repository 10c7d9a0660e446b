// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <string>

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
  void ask_for_memory();

  InputsTap& tap_;
  const Clock& clock_;
  const Time began_;
  WallTime wall_;
  InputsComposer compose_;
  wire::Participant& participant_;
  std::string topic_;
  std::optional<wire::Writer<msg::TickInputs>> writer_;
  bool wrote_ = false;  ///< something since the writer was made
  std::deque<msg::TickInputs> waiting_;
  std::size_t waiting_bytes_ = 0;
  Time next_memory_;
  Worker worker_;
};

}  // namespace galilean::robot
