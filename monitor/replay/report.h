// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// Returns lines about the recording `path`: what will be played, what not, and its damage.
[[nodiscard]] std::string before_playing(const std::string& path, const mcap::Summary& summary,
                                         const Tracks& tracks);

/// Returns those damages that a replay met and that the summary did not know.
[[nodiscard]] std::vector<mcap::Damage> newly_met(const std::vector<mcap::Damage>& met,
                                                  const mcap::Summary& summary);

/// Returns the names as a list: "io", "io and callisto", "io, ganymede and callisto".
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

}  // namespace galilean::monitor
