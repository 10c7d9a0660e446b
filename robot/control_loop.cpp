// SPDX-License-Identifier: BSD-3-Clause
#include "robot/control_loop.h"

#include <poll.h>
#include <pthread.h>
#include <sched.h>

#include <utility>

#include "robot/pacing.h"

namespace galilean::robot {
namespace {

void ask_for_real_time() noexcept {
  sched_param parameters{};
  parameters.sched_priority = sched_get_priority_min(SCHED_FIFO);
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

/// Sleeps until `deadline`. Returns false if `wake` ended the sleep before.
bool sleep_until(Time deadline, const Clock& clock, Wake& wake) noexcept {
  constexpr long kSecond_ns = 1'000'000'000;
  pollfd rung{wake.descriptor(), POLLIN, 0};
  for (Time now = clock.now(); now < deadline; now = clock.now()) {
    const long left_ns = (deadline - now).count();
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
        const SteadyClock clock;
        Pacing pacing(clock.now(), period);
        while (true) {
          const bool in_time = sleep_until(pacing.deadline(), clock, wake);
          if (stop.stop_requested()) return;
          tick();
          if (in_time) pacing.advance(clock.now());
        }
      }) {}

}  // namespace galilean::robot
