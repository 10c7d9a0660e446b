// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/map_watch.h"

#include <cmath>
#include <iostream>
#include <utility>

namespace galilean::monitor {
namespace {

constexpr const char* kOthersGoOn = " Stop, hold and all other commands go on without it.";

/// Returns how the sentence begins that tells of a failure.
std::string losing(std::string_view why) {
  return "The map loses updates: " + std::string(why) + ".";
}

}  // namespace

void MapWatch::note_alive() {
  const std::lock_guard lock(mutex_);
  alive_ = clock_.now();
}

bool MapWatch::note(Count& count) const {
  const Time now = clock_.now();
  const bool is_new = !is_lately(count, now);
  ++count.times;
  count.newest = now;
  return is_new;
}

bool MapWatch::is_lately(const Count& count, Time now) const {
  return count.times > 0 && now - count.newest < kTold;
}

void MapWatch::note_failure(std::string_view why) {
  bool is_new = false;
  {
    const std::lock_guard lock(mutex_);
    is_new = note(failures_);
    newest_failure_ = why;
  }
  if (is_new) std::clog << "galilean-monitor: " + losing(why) + "\n" << std::flush;
}

void MapWatch::note_dropped() {
  const std::lock_guard lock(mutex_);
  (void)note(dropped_);
}

std::string MapWatch::problem() const {
  const std::lock_guard lock(mutex_);
  const Time now = clock_.now();
  if (now - alive_ > kPatience)
    return "The map has stood still for " +
           std::to_string(std::lround(std::floor(to_seconds(now - alive_)))) + " s." + kOthersGoOn;
  if (is_lately(failures_, now)) return losing(newest_failure_) + kOthersGoOn;
  if (is_lately(dropped_, now))
    return "The map is given more messages than it takes in; it has dropped " +
           std::to_string(dropped_.times) + " of them so far." + kOthersGoOn;
  return {};
}

std::uint64_t MapWatch::failures() const {
  const std::lock_guard lock(mutex_);
  return failures_.times;
}

std::uint64_t MapWatch::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_.times;
}

}  // namespace galilean::monitor
