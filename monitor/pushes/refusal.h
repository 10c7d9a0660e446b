// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/result.h"
#include "monitor/pushes/history/order_record.h"
#include "monitor/pushes/history/push_record.h"
#include "monitor/pushes/target_check.h"

namespace galilean::monitor {

/// A program that runs where an order is to replace another one.
struct Stale {
  std::string robot;  ///< the robot that runs it; empty: the team as a whole
  std::string hash;
};

/// The reason why an order is refused, or why a question about a push has no answer.
struct Refusal {
  enum class Reason {
    kNotFound,    ///< there is no such robot or push
    kConflict,    ///< the order contradicts what the robots run or do
    kBroken,      ///< the program has errors
    kUnavailable  ///< this machine cannot do it now
  };
  Reason reason = Reason::kConflict;
  std::string message;  ///< one sentence

  std::optional<PushRecord> pushed = {};          ///< the push that is the reason
  std::optional<std::string> running_hash = {};   ///< the program that runs instead
  std::optional<PushRecord> running_pushed = {};  ///< the push that brought it; none is known
  std::optional<TargetCheck> check = {};          ///< the check that found errors
};

/// The answer to an order, or to a question about a push.
using PushAnswer = Result<PushRecord, Refusal>;

[[nodiscard]] Refusal not_found(std::string message);
[[nodiscard]] Refusal conflict(std::string message);
[[nodiscard]] Refusal unavailable(std::string message);
/// Returns the refusal of what this machine cannot do now. `why` is a clause.
[[nodiscard]] Refusal cannot_now(const std::string& why);

/// Returns the refusal of an order while `other` is under way to the same robots. `running_hash` is
/// the program that runs meanwhile, and `by` the push that brought it, as far as they are known.
[[nodiscard]] Refusal under_way(const PushRecord& other, const std::string& running_hash,
                                const std::optional<PushRecord>& by);
/// Returns the refusal of an order to replace a program that no longer runs. `by` is the push that
/// brought the program that runs; none if this monitor knows of none.
[[nodiscard]] Refusal replaced_meanwhile(const std::string& replaces, const Stale& stale,
                                         const std::optional<PushRecord>& by);
/// Returns the refusal of a program with errors.
[[nodiscard]] Refusal broken(TargetCheck check);
/// Returns the refusal to cancel `push`, which can no longer be cancelled.
[[nodiscard]] Refusal too_late(const PushRecord& push);

/// Returns the order of `push`, which was refused, as the history keeps it.
[[nodiscard]] RefusedPush kept_form(const Refusal& refusal, const PushRecord& push);
/// Returns the refusal of an order that the history tells to have been refused.
[[nodiscard]] Refusal refused_before(const RefusedPush& kept);

/// Returns {pushed, running_hash, running_pushed, robot, diagnostics}, without what the refusal
/// does not have.
[[nodiscard]] nlohmann::json to_json(const Refusal& refusal);

}  // namespace galilean::monitor
