// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/geometry.h"
#include "core/wire/messages.h"

namespace galilean::front {

/// Judges whether a team worked, from the messages of its robots and of the referee.
class Evidence {
 public:
  explicit Evidence(std::vector<std::string> robots);

  void note(const msg::RobotState& state);
  void note(const msg::Score& score) { score_ = score; }

  /// Returns a sentence for each shortcoming; without any, the team worked. Each robot must have
  /// sent its state, run a program, left its first state, and driven a metre or thrown a piece
  /// away.
  [[nodiscard]] std::vector<std::string> shortcomings() const;
  /// Returns a line for each robot and one for the referee.
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

  std::map<std::string, Deeds> deeds_;  ///< by the name of each robot that should work
  msg::Score score_;
};

}  // namespace galilean::front
