// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <thread>

namespace galilean::wire {

/// Checks `condition` every millisecond, for at most ten seconds, because discovery has no clock to
/// step. Returns whether the condition held.
template <class Condition>
[[nodiscard]] bool wait_until(Condition condition) {
  for (int i = 0; i < 10000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

}  // namespace galilean::wire
