// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <thread>

namespace galilean::wire {

/// Waits until the condition is true, because discovery has no clock to step. Looks every
/// millisecond, for ten seconds at most.
template <class Condition>
[[nodiscard]] bool wait_until(Condition condition) {
  for (int i = 0; i < 10000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return condition();
}

}  // namespace galilean::wire
