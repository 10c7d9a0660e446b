// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// Returns the map as a .3Dscene file, which MRPT's SceneViewer3D opens: the occupancy grid, each
/// object as opaque as it is certain with its 95 % ellipse, and each robot with its name. `grid`
/// may be empty.
[[nodiscard]] std::string map_scene(const msg::OccupancyGrid& grid, const msg::ObjectMap& map);

}  // namespace galilean::monitor
