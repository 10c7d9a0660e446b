// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// What is about to be played of the recording `path`, and what is not, in lines for its reader.
[[nodiscard]] std::string before_playing(const std::string& path, const mcap::Summary& summary,
                                         const Tracks& tracks);

/// "io", "io and callisto", "io, ganymede and callisto".
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

}  // namespace galilean::monitor
