// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/pushes/push_order.h"
#include "monitor/pushes/push_record.h"
#include "monitor/pushes/push_requests.h"
#include "monitor/pushes/rollout.h"
#include "monitor/pushes/steps.h"

namespace galilean::monitor {

/// What one push is about: the order and, once it is checked, the program. It composes what the
/// push asks for and tells.
class PushContent {
 public:
  /// Requires: the order has a file.
  PushContent(PushOrder order, PushIdentity identity);
  /// Of a push that somebody made past this monitor.
  explicit PushContent(const msg::ProgramPush& message);

  /// Keeps the program that the check found to be right. What is recorded and sent is made of it.
  void set_program(const CheckedProgram& program);

  /// Returns to whom the program goes, and which of them runs it first.
  [[nodiscard]] RolloutPlan plan(const OrderTargets& targets) const;
  /// Returns the steps that the order asks for. `has_rest`: there are robots besides the canary.
  [[nodiscard]] Steps steps(bool has_rest) const;

  // The requests that the push makes on its way. All but the first require set_program().

  /// Returns the request to check the program against the catalogs of `robots`.
  [[nodiscard]] CheckProgram check(std::vector<Target> robots) const;
  [[nodiscard]] RecordPush recording(Progress progress) const {
    return {message_, std::move(progress)};
  }
  /// Returns the request to try the program beside the one that the first of `robots` runs.
  [[nodiscard]] TryProgram trial(std::vector<std::string> robots) const;
  /// Requires: the order names a canary.
  [[nodiscard]] SendProgram to_canary() const;
  /// `rest`: the targets without the canary.
  [[nodiscard]] SendProgram to_rest(std::vector<std::string> rest) const;
  /// Returns the order that takes the program off the canary again.
  [[nodiscard]] RollBack rollback(const std::string& reason) const;
  /// Returns what the history and those who ask are told of the push.
  [[nodiscard]] PushRecord record(Progress progress, std::vector<RobotReply> replies) const;

  [[nodiscard]] const PushOrder& order() const noexcept { return order_; }
  [[nodiscard]] const PushIdentity& identity() const noexcept { return identity_; }
  /// The order that takes the program off the canary is replied to as well.
  [[nodiscard]] bool is_meant_by(const msg::ProgramReply& reply) const;
  [[nodiscard]] bool is_ours() const noexcept { return is_ours_; }

 private:
  [[nodiscard]] SendProgram sending(std::vector<std::string> robots) const;

  PushOrder order_;
  PushIdentity identity_;
  bool is_ours_;
  msg::ProgramPush message_;  ///< once the program is checked
};

}  // namespace galilean::monitor
