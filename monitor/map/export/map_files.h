#pragma once

#include <string>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// The floor as ROS' map_server reads it: a picture, 8-bit grey, north up, 254 free, 0 occupied,
/// 205 unknown; and where it lies, in a file that names the picture map.png.
[[nodiscard]] std::string map_png(const msg::OccupancyGrid& grid);
[[nodiscard]] std::string map_yaml(const msg::OccupancyGrid& grid);

}  // namespace galilean::monitor
