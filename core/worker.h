// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <thread>

#include "core/clock.h"

namespace galilean {

/// A thread that does its rounds over and over, until this is destroyed. What a round throws ends
/// neither the thread nor the process: it is reported, and after a pause the next round tries
/// again.
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

/// Sleeps; not on when `stop` is requested.
void sleep_for(Duration duration, const std::stop_token& stop);

}  // namespace galilean
