// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/orders/order_check.h"
#include "core/result.h"
#include "core/wire/messages.h"
#include "robot/executive/executive.h"

namespace galilean::robot {

/// Gives the executive the operators' orders about where and when it stands still, and remembers
/// who gave them and what the robot answers. Any thread but the control loop may call it.
class BreakDesk {
 public:
  static constexpr std::size_t kAnswersKept = 16;
  static constexpr std::size_t kRefusalsKept = 8;  ///< so many of these, of orders not carried out

  struct Told {
    std::uint64_t orders = 0;  ///< how many were given: another number means that something changed
    /// To the newest orders about break points, steps and refused commands, the oldest first. An
    /// answer stays for some orders more, because several operators may give theirs between two
    /// messages.
    std::vector<msg::BreakAnswer> answers;
    std::string stepped_by;   ///< who ordered the newest step
    msg::TeamStop team_stop;  ///< of Hold::kTeam: what stopped the team
  };

  /// `held_by` names who holds the robot already. Requires: `executive` outlives this.
  BreakDesk(std::string robot, Executive& executive, std::string held_by = {})
      : robot_(std::move(robot)), executive_(executive), held_by_(std::move(held_by)) {}

  void hold(const msg::Command& command);
  /// Another robot's break point stops the team. A robot that stands already is left as it is.
  void stop_with_team(const msg::TeamStop& stop);
  void resume(const msg::Command& command);
  void step(const msg::Command& command);
  void obey(const msg::BreakOrder& order);
  /// Answers an order that is not admitted. One that was sent again is not answered again.
  void refuse(const std::string& order_id, const OrderRefusal& refusal);

  [[nodiscard]] Told told() const;
  /// Returns who ordered the newest hold; empty: nobody.
  [[nodiscard]] std::string held_by() const;
  /// Returns Told::orders, without a copy of the texts.
  [[nodiscard]] std::uint64_t orders() const;

 private:
  [[nodiscard]] Result<void> begin_step();
  void answer(const std::string& id, const std::string& what, const Result<void>& done);
  void keep_answer(const std::string& id, const std::string& refused);
  [[nodiscard]] Result<void> carry_out(const msg::BreakOrder& order);
  [[nodiscard]] Result<void> set(const msg::BreakOrder& order);

  const std::string robot_;
  Executive& executive_;
  mutable std::mutex mutex_;
  std::string held_by_;
  std::deque<std::string> refused_ids_;  ///< of the newest orders that were not admitted
  Told told_;
};

}  // namespace galilean::robot
