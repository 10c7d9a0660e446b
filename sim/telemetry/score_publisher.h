// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/result.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"
#include "sim/world/world.h"

namespace galilean::sim {

/// Publishes the referee's sheet on rt/referee/score, twice a second and at each change. It uses a
/// thread of its own, because a write may block and the world must not.
class ScorePublisher {
 public:
  explicit ScorePublisher(wire::Participant& participant);
  ~ScorePublisher();
  ScorePublisher(const ScorePublisher&) = delete;
  ScorePublisher& operator=(const ScorePublisher&) = delete;

  /// Takes the world's present sheet. It never waits for the network.
  void show(const World& world);

 private:
  void run();

  wire::Writer<msg::Score> writer_;
  std::mutex mutex_;
  std::condition_variable changed_;
  msg::Score newest_;
  bool fresh_ = false;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace galilean::sim
