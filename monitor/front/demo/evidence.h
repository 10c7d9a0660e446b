// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/geometry.h"
#include "core/wire/messages.h"

namespace galilean::front {

/// Whether a team worked, by what its robots and the referee said. Pure.
class Evidence {
 public:
  explicit Evidence(std::vector<std::string> robots);

  void note(const msg::RobotState& state);
  void note(const msg::Score& score) { score_ = score; }

  /// One sentence a shortcoming; none: the team worked. Each robot must have been heard, run a
  /// program, changed its state after the start, and driven a metre or thrown a piece away.
  [[nodiscard]] std::vector<std::string> shortcomings() const;
  /// A line for each robot and one for the referee.
  [[nodiscard]] std::string summary() const;

 private:
  struct Deeds {
    std::uint64_t messages = 0;
    std::string program_hash, program_name, state;
    std::uint64_t transitions = 0;
    std::uint32_t overruns = 0;
    double driven_m = 0;
    Vec2 position_m = Vec2::Zero();
  };
  [[nodiscard]] std::uint32_t deposited_by(const std::string& robot) const;

  std::map<std::string, Deeds> deeds_;  ///< of every robot that should work
  msg::Score score_;
};

}  // namespace galilean::front
