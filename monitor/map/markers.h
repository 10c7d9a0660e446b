#pragma once

#include "core/wire/messages.h"

namespace galilean::monitor {

/// The object map for rviz2 and Foxglove: a cylinder a thing, as opaque as it is certain, and an
/// arrow-like box with its name a robot. Each lives a little longer than the map's period.
[[nodiscard]] msg::MarkerArray markers(const msg::ObjectMap& map);

}  // namespace galilean::monitor
