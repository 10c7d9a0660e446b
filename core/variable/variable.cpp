// SPDX-License-Identifier: BSD-3-Clause
#include "core/variable/variable.h"

#include <algorithm>

namespace galilean {

double Reliability::certainty_at(Time now) const noexcept {
  if (!valid) return 0;
  return std::clamp(certainty - decay_per_s * to_seconds(now - stamp), 0.0, 1.0);
}

const char* to_string(ObjectClass object) noexcept {
  switch (object) {
    case ObjectClass::kTrash:
      return "trash";
    case ObjectClass::kBasket:
      return "basket";
    case ObjectClass::kObstacle:
      return "obstacle";
    case ObjectClass::kRobot:
      return "robot";
    case ObjectClass::kUnknown:
      break;
  }
  return "unknown";
}

}  // namespace galilean
