#pragma once

#include <string>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// A map as ROS' map_server reads it.
struct MapFiles {
  std::string png;   ///< 8-bit grey, north up: 254 free, 0 occupied, 205 unknown
  std::string yaml;  ///< names the picture map.png
};
[[nodiscard]] MapFiles map_files(const msg::OccupancyGrid& grid);

}  // namespace galilean::monitor
