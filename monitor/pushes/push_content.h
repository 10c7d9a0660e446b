// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/pushes/history/push_record.h"
#include "monitor/pushes/push_order.h"
#include "monitor/pushes/push_requests.h"
#include "monitor/pushes/rollout/rollout.h"
#include "monitor/pushes/rollout/steps.h"

namespace galilean::monitor {

/// The content of a push: its order and, once it is checked, its program. It composes the push's
/// requests and its record.
class PushContent {
 public:
  /// Requires: the order has a file.
  PushContent(PushOrder order, PushIdentity identity);
  /// Makes the content of a push that was made without this monitor.
  explicit PushContent(const msg::ProgramPush& message);

  /// Sets the program that passed the check. It is what is recorded, tried and sent.
  void set_program(const CheckedProgram& program);

  /// Returns which robots get the program, and which of them runs it first.
  [[nodiscard]] RolloutPlan plan(const OrderTargets& targets) const;
  /// Returns the steps that the order asks for. `has_rest` says whether there are robots besides
  /// the canary.
  [[nodiscard]] Steps steps(bool has_rest) const;

  // The requests of the push. All but check() require set_program().

  /// Returns the request to check the program against the catalogs of `robots`.
  [[nodiscard]] CheckProgram check(std::vector<Target> robots) const;
  [[nodiscard]] RecordPush recording(Progress progress) const {
    return {message_, std::move(progress)};
  }
  /// Returns the request to try the program beside the one that `robots` run.
  [[nodiscard]] TryProgram trial(std::vector<std::string> robots) const;
  /// Requires: the order names a canary.
  [[nodiscard]] SendProgram to_canary() const;
  /// `rest` is the targets without the canary.
  [[nodiscard]] SendProgram to_rest(std::vector<std::string> rest) const;
  /// Returns the order that takes the program off the canary again.
  [[nodiscard]] RollBack rollback(const std::string& reason) const;

  /// Returns the push as it is recorded and published.
  [[nodiscard]] PushRecord record(Progress progress, std::vector<RobotReply> replies) const;

  [[nodiscard]] const PushOrder& order() const noexcept { return order_; }
  [[nodiscard]] const PushIdentity& identity() const noexcept { return identity_; }
  /// Returns the program's files that the order did not bring. Requires: set_program().
  [[nodiscard]] const std::vector<TakenFile>& taken() const noexcept { return taken_; }
  /// Returns whether the reply is to this push. The canary's reply that it has rolled the program
  /// back as ordered counts as one.
  [[nodiscard]] bool is_meant_by(const msg::ProgramReply& reply) const;
  [[nodiscard]] bool is_ours() const noexcept { return is_ours_; }

 private:
  [[nodiscard]] SendProgram sending(std::vector<std::string> robots) const;

  PushOrder order_;
  PushIdentity identity_;
  bool is_ours_;
  msg::ProgramPush message_;  ///< complete only after set_program()
  std::vector<TakenFile> taken_;
};

}  // namespace galilean::monitor
