// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
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

/// An order to stop all. A robot confirms it by a state of its own that was received after the
/// order and says that it stands still. One that stands at a break point has not confirmed yet,
/// because a step would let it go on. One that has confirmed is done, whoever resumes it later.
class StopOrder {
 public:
  explicit StopOrder(Time ordered) : ordered_(ordered) {}

  /// Notes who confirms now. Call it some times a second.
  void update(const Team& team);
  /// Takes a robot out of the order, because it is resumed.
  void release(const std::string& robot) { released_.insert(robot); }
  [[nodiscard]] StopProgress progress(const Team& team, Time now) const;

 private:
  [[nodiscard]] bool is_answered_by(const Robot& robot) const;
  [[nodiscard]] bool is_confirmed_by(const Robot& robot) const;

  Time ordered_;
  std::set<std::string> confirmed_, released_;
};
/// Returns "2 of 3 stopped; callisto has not answered for 14 s".
[[nodiscard]] std::string stop_sentence(const StopProgress& progress);

}  // namespace galilean::monitor::top
