// SPDX-License-Identifier: BSD-3-Clause
#include "core/worker.h"

#include <condition_variable>
#include <mutex>
#include <utility>

#include "core/failure.h"

namespace galilean {
namespace {

void work(const Worker::Round& round, const Worker::Report& report, const std::stop_token& stop) {
  std::string told;
  while (!stop.stop_requested()) {
    const auto done = attempt([&] { round(stop); });
    std::string failure = done ? "" : done.error().message;
    const bool is_told = failure == told || attempt([&] { report(failure); });
    if (is_told) told = std::move(failure);
    if (!done) static_cast<void>(attempt([&] { sleep_for(Worker::kTryAgain, stop); }));
  }
}

}  // namespace

Worker::Worker(Round round, Report report)
    : thread_([round = std::move(round), report = std::move(report)](const std::stop_token& stop) {
        work(round, report, stop);
      }) {}

void sleep_for(Duration duration, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any wake;
  std::unique_lock lock(mutex);
  wake.wait_for(lock, stop, duration, [] { return false; });
}

}  // namespace galilean
