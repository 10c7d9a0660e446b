// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/topic_names.h"

namespace galilean::wire {

std::string robot_topic(std::string_view robot, std::string_view leaf) {
  return "rt/" + std::string(robot) + "/" + std::string(leaf);
}

}  // namespace galilean::wire
