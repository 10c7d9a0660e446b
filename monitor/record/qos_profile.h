// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/endpoints.h"

namespace galilean::monitor {

/// Returns the quality of service that a topic was offered with, in YAML. A channel of MCAP's
/// profile "ros2" must state it, so that ROS 2 replays the topic in the same way.
[[nodiscard]] std::string offered_qos_profiles(const wire::EndpointQos& offered);

}  // namespace galilean::monitor
