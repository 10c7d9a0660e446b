// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/team/team.h"

namespace galilean::monitor::top {

/// A robot that has not said since the order that it stands still.
struct Unconfirmed {
  std::string robot;
  double waits_s = 0;      ///< since it was last heard, or since the order if it answers
  bool drives_on = false;  ///< it was heard since the order: it answers, but does not stop
};
/// Who has stopped since the order to stop all.
struct StopProgress {
  std::vector<std::string> stopped;
  std::vector<Unconfirmed> unconfirmed;  ///< those that wait longest first
};

/// A robot confirms by a state of its own that was received after the order and says that it
/// stands still.
[[nodiscard]] StopProgress stop_progress(const Team& team, Time ordered, Time now);
/// Returns "2 of 3 stopped; callisto has not answered for 14 s".
[[nodiscard]] std::string stop_sentence(const StopProgress& progress);

}  // namespace galilean::monitor::top
