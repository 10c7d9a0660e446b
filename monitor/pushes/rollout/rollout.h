// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "monitor/pushes/history/replies.h"
#include "monitor/pushes/rollout/canary.h"
#include "monitor/pushes/rollout/verdict.h"

namespace galilean::monitor {

/// The robots that a program goes to.
struct RolloutPlan {
  std::string push_id;
  std::vector<std::string> awaited;  ///< targets that are heard, or that the order names
  std::vector<std::string> silent;   ///< the team's others, which may come back and must reply, too
  std::string canary;                ///< one of `awaited`, which runs it first; empty: none
  Duration probation = std::chrono::seconds(10);  ///< how long the canary must run it
};

/// Rolls a program out to its robots: to the canary first, if there is one, then to the rest. The
/// class does no input or output: its owner sends the program, and brings replies and time.
class Rollout {
 public:
  explicit Rollout(RolloutPlan plan) : plan_(std::move(plan)) {}

  /// Call it when the program is sent to the canary. Requires: there is one.
  void begin_canary(Time now);
  /// Call it when the program is sent to all the others.
  void begin_rest(Time now);

  /// Takes in a reply. Returns what is known of the robot now; nothing if the reply is to another
  /// push, tells nothing new, or comes before the program was sent to the robot.
  std::optional<RobotReply> note(const msg::ProgramReply& reply, Time now);
  /// Requires: begin_canary.
  [[nodiscard]] Verdict judge_canary(Time now) { return canary_->judge(now); }
  [[nodiscard]] Verdict see_canary(bool silent, const std::string& running_hash, Time now) const {
    return canary_->see(silent, running_hash, now);
  }
  [[nodiscard]] bool canary_may_run_it() const { return canary_->may_run_it(); }
  /// Requires: begin_rest.
  [[nodiscard]] Verdict judge_rest(Time now) const;

  /// Returns whether begin_rest() was called. Every target has then been sent the program.
  [[nodiscard]] bool has_reached_all() const noexcept { return rest_.has_value(); }
  [[nodiscard]] const RolloutPlan& plan() const noexcept { return plan_; }
  /// Returns the targets without the canary.
  [[nodiscard]] std::vector<std::string> rest() const;
  /// Returns what each robot that was sent the program has replied, in the order of their names.
  [[nodiscard]] std::vector<RobotReply> replies() const;
  /// Returns how many replies were dropped; see Replies.
  [[nodiscard]] std::uint64_t replies_dropped() const noexcept {
    return rest_ ? rest_->dropped() : 0;
  }

 private:
  [[nodiscard]] std::string shortcomings() const;

  RolloutPlan plan_;
  std::optional<Canary> canary_;
  std::optional<Replies> rest_;
  Time rest_sent_{};
};

}  // namespace galilean::monitor
