// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/termination.h"
#include "monitor/top/dashboard_feed.h"

namespace galilean::monitor::top {

/// Prints one snapshot as plain text, of this robot if there is one of that name. Waits at most 3 s
/// until all is known of the robots, and then 0.5 s more for robots that are discovered later.
/// Returns the process' exit code, which is 1 if there are no robots.
[[nodiscard]] int print_once(DashboardFeed& feed, Termination& termination, const Clock& clock,
                             const std::string& robot);

}  // namespace galilean::monitor::top
