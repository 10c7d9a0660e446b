// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/delivery.h"

namespace galilean::monitor {

/// How a topic was offered, as a channel of MCAP's profile "ros2" must say it: in YAML, so that
/// ROS 2 replays it in the same way.
[[nodiscard]] std::string offered_qos_profiles(wire::Delivery delivery);

}  // namespace galilean::monitor
