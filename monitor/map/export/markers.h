// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wire/messages.h"

namespace galilean::monitor {

/// Returns the object map for rviz2 and Foxglove: a cylinder for each object, as opaque as it is
/// certain, a box with its name for each robot, and the 95 % ellipses of both. A marker lives a
/// little longer than the map's period.
[[nodiscard]] msg::MarkerArray markers(const msg::ObjectMap& map);

}  // namespace galilean::monitor
