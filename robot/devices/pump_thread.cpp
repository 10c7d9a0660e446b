// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/pump_thread.h"

#include <utility>

namespace galilean::robot {

PumpThread::PumpThread(const Clock& clock, Duration pause, std::function<void(Time)> pump,
                       std::function<void(const std::string& why)> fail)
    : worker_(
          [&clock, pause, pump = std::move(pump)](const std::stop_token& stop) {
            pump(clock.now());
            sleep_for(pause, stop);
          },
          [fail = std::move(fail)](const std::string& failure) {
            if (!failure.empty()) fail(failure);
          }) {}

}  // namespace galilean::robot
