#pragma once

#include "core/wire/messages.h"

namespace galilean::monitor {

/// The object map for rviz2 and Foxglove: a cylinder a landmark, as opaque as it is certain, a box
/// with its name a robot, and the 95 % ellipse of either. Each lives a little longer than the map's
/// period.
[[nodiscard]] msg::MarkerArray markers(const msg::ObjectMap& map);

}  // namespace galilean::monitor
