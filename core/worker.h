// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <thread>

#include "core/clock.h"

namespace galilean {

/// A thread that repeats a round until this object is destroyed. An exception from a round ends
/// neither the thread nor the process. It is reported, and the next round begins after a pause.
class Worker {
 public:
  /// One round. It waits by itself for work, but no longer than until `stop` is requested.
  using Round = std::function<void(const std::stop_token& stop)>;
  /// Is called in the worker's thread with the reason why a round failed, once for rounds in a row
  /// that fail alike, and with an empty text when a round succeeds again.
  using Report = std::function<void(const std::string& failure)>;

  static constexpr Duration kTryAgain = std::chrono::milliseconds(500);

  /// Makes a worker that has no thread and does nothing.
  Worker() = default;
  Worker(Round round, Report report);

 private:
  std::jthread thread_;
};

/// Sleeps for `duration`, or until `stop` is requested.
void sleep_for(Duration duration, const std::stop_token& stop);

}  // namespace galilean
