// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "monitor/replay/neighbours.h"
#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// Returns lines about the recording `path`: what will be played, what not, and its damage.
[[nodiscard]] std::string before_playing(const std::string& path, const mcap::Summary& summary,
                                         const Tracks& tracks);

/// Returns lines about which robots are played, which are left out, and which are live in the
/// domain or played there by another replay.
[[nodiscard]] std::string who_is_where(const std::set<std::string>& recorded,
                                       const std::set<std::string>& played,
                                       const wire::Neighbours& there);

/// Returns why a replay must not begin beside those of the same names. Requires: there are some.
[[nodiscard]] std::string why_not_beside(const wire::Neighbours& namesakes);

/// Returns those damages that a replay met and that the summary did not know.
[[nodiscard]] std::vector<mcap::Damage> newly_met(const std::vector<mcap::Damage>& met,
                                                  const mcap::Summary& summary);

/// Returns the names as a list: "io", "io and callisto", "io, ganymede and callisto".
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

}  // namespace galilean::monitor
