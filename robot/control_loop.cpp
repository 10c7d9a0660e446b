#include "robot/control_loop.h"

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

}  // namespace

ControlLoop::ControlLoop(Duration period, std::function<void()> tick)
    : thread_([period, tick = std::move(tick)](const std::stop_token& stop) {
        ask_for_real_time();
        for (auto deadline = Steady::now(); !stop.stop_requested();
             deadline = next_deadline(deadline, period)) {
          std::this_thread::sleep_until(deadline);
          tick();
        }
      }) {}

}  // namespace galilean::robot
