// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/turn.h"

#include <thread>

namespace galilean::robot {

bool wait_for_turn(const Executive& executive) {
  constexpr Duration kPatience = std::chrono::seconds(1);
  constexpr Duration kPause = std::chrono::milliseconds(1);
  for (Duration waited{}; executive.waiting(); waited += kPause) {
    if (waited > kPatience) return false;
    std::this_thread::sleep_for(kPause);
  }
  return true;
}

}  // namespace galilean::robot
