// SPDX-License-Identifier: BSD-3-Clause
#include "robot/control_loop.h"

#include <poll.h>
#include <pthread.h>
#include <sched.h>

#include <utility>

namespace galilean::robot {
namespace {

using Steady = std::chrono::steady_clock;

void ask_for_real_time() noexcept {
  sched_param parameters{};
  parameters.sched_priority = sched_get_priority_min(SCHED_FIFO);
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

Steady::time_point next_deadline(Steady::time_point last, Duration period) noexcept {
  const auto next = last + period;
  const auto now = Steady::now();
  return now < next ? next : next + (now - next) / period * period;
}

/// False if it was woken before.
bool sleep_until(Steady::time_point deadline, Wake& wake) noexcept {
  constexpr long kSecond_ns = 1'000'000'000;
  pollfd rung{wake.descriptor(), POLLIN, 0};
  for (auto now = Steady::now(); now < deadline; now = Steady::now()) {
    const long left_ns = std::chrono::nanoseconds(deadline - now).count();
    const timespec timeout{left_ns / kSecond_ns, left_ns % kSecond_ns};
    if (ppoll(&rung, 1, &timeout, nullptr) <= 0) continue;
    wake.clear();
    return false;
  }
  return true;
}

}  // namespace

ControlLoop::ControlLoop(Duration period, Wake& wake, std::function<void()> tick)
    : thread_([period, &wake, tick = std::move(tick)](const std::stop_token& stop) {
        const std::stop_callback ring(stop, [&wake] { wake.ring(); });
        ask_for_real_time();
        auto deadline = Steady::now();
        while (true) {
          const bool in_time = sleep_until(deadline, wake);
          if (stop.stop_requested()) return;
          tick();
          if (in_time) deadline = next_deadline(deadline, period);
        }
      }) {}

}  // namespace galilean::robot
