// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "core/clock.h"

namespace galilean::monitor {

/// The robots whose messages are taken in. Whoever writes to DDS can invent names, so it has kMost
/// places. A robot keeps its place while it is heard. One that was silent for kForgetAfter gives
/// its place to a robot that needs one, and not before that.
class RobotRoster {
 public:
  static constexpr std::size_t kMost = 256;
  static constexpr Duration kForgetAfter = std::chrono::hours(1);

  /// What became of a robot that was heard.
  struct Admission {
    bool is_followed = false;    ///< it has a place; otherwise all places are taken
    std::string forgotten = {};  ///< the robot that gave it its place; empty: none had to
  };
  /// Notes that a valid message of `robot` came. Requires: `now` does not go back.
  [[nodiscard]] Admission hear(std::string_view robot, Time now);

  [[nodiscard]] std::size_t size() const noexcept { return heard_.size(); }
  /// Returns how many robots gave their places to others.
  [[nodiscard]] std::size_t forgotten() const noexcept { return forgotten_; }

 private:
  /// Returns the name of the robot that was silent for longest and long enough, and takes it off.
  /// Returns an empty string if there is none.
  [[nodiscard]] std::string forget_one(Time now);

  std::map<std::string, Time, std::less<>> heard_;  ///< by robot: when it was heard last
  std::size_t forgotten_ = 0;
  /// Nobody can be forgotten before this. It keeps a flood of names from a search for each.
  Time next_search_{};
};

}  // namespace galilean::monitor
