#include "robot/devices/pump_thread.h"

#include <condition_variable>
#include <mutex>
#include <utility>

namespace galilean::robot {

PumpThread::PumpThread(const Clock& clock, Duration pause, std::function<void(Time)> pump)
    : thread_([&clock, pause, pump = std::move(pump)](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any wake;
        std::unique_lock lock(mutex);
        while (!stop.stop_requested()) {
          pump(clock.now());
          wake.wait_for(lock, stop, pause, [] { return false; });
        }
      }) {}

}  // namespace galilean::robot
