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
  /// Waits by itself for what it works on, at most until `stop` is requested.
  using Round = std::function<void(const std::stop_token& stop)>;
  /// Learns in the worker's thread why a round failed, once for rounds in a row that fail alike,
  /// and the empty text when a round succeeded again.
  using Report = std::function<void(const std::string& failure)>;

  static constexpr Duration kTryAgain = std::chrono::milliseconds(500);

  /// Does nothing.
  Worker() = default;
  Worker(Round round, Report report);

 private:
  std::jthread thread_;
};

/// Sleeps for `duration`, or until `stop` is requested.
void sleep_for(Duration duration, const std::stop_token& stop);

}  // namespace galilean
