// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// Returns the grid as ROS' map_server reads it: a PNG picture, 8-bit grey, y up, with 254 for
/// free, 0 for occupied and 205 for unknown.
[[nodiscard]] std::string map_png(const msg::OccupancyGrid& grid);
/// Returns the file that says where the picture lies. It names the picture map.png.
[[nodiscard]] std::string map_yaml(const msg::OccupancyGrid& grid);

}  // namespace galilean::monitor
