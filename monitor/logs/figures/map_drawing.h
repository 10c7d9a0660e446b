// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/logs/figures/map_tracks.h"

namespace galilean::logs {

/// Returns the tracks over the floor as a picture: y goes up, free floor is light and occupied
/// floor dark. A track begins with a ring and ends with the robot's name. Requires: there is a
/// track.
[[nodiscard]] Drawing map_drawing(const MapTracks& tracks);

/// Returns the same in letters: a letter for each robot, '#' for what is occupied and '.' for what
/// is free. Requires: there is a track; `width` and `height` are at least 10 and 3.
[[nodiscard]] std::string map_text(const MapTracks& tracks, std::size_t width, std::size_t height);

/// Returns a sentence without a full stop on whose word the tracks are.
[[nodiscard]] std::string source_text(MapTracks::Source source);

}  // namespace galilean::logs
