// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/result.h"
#include "monitor/pushes/push_record.h"
#include "monitor/pushes/target_check.h"

namespace galilean::monitor {

/// Another program than the one that an order is to replace, where one runs.
struct Stale {
  std::string robot;  ///< that runs it; empty: the team as a whole
  std::string hash;
};

/// Why an order is refused, or a question about a push has no answer.
struct Refusal {
  enum class Reason {
    kNotFound,    ///< there is no such robot or push
    kConflict,    ///< it does not go together with what the robots run or do
    kBroken,      ///< the program has errors
    kUnavailable  ///< this machine could not do it
  };
  Reason reason = Reason::kConflict;
  std::string message;  ///< one sentence

  // What goes with it:
  std::optional<PushRecord> pushed = {};         ///< the push that stands against it
  std::optional<std::string> running_hash = {};  ///< the program that runs instead
  std::optional<TargetCheck> check = {};         ///< with the errors
};

/// What whoever orders a push or asks about one is told.
using PushAnswer = Result<PushRecord, Refusal>;

[[nodiscard]] Refusal not_found(std::string message);
[[nodiscard]] Refusal conflict(std::string message);
[[nodiscard]] Refusal unavailable(std::string message);
/// Of a question that this machine could not look up.
[[nodiscard]] Refusal cannot_now(const std::string& why);

/// `other` is under way to the same robots.
[[nodiscard]] Refusal under_way(const PushRecord& other);
/// Another program runs than the one that was to be replaced. `by`: the push that brought it; none
/// if this monitor knows of none.
[[nodiscard]] Refusal overtaken(const std::string& replaces, const Stale& stale,
                                const std::optional<PushRecord>& by);
[[nodiscard]] Refusal broken(TargetCheck check);
/// `push` can no longer be cancelled.
[[nodiscard]] Refusal too_late(const PushRecord& push);

/// {pushed, running_hash, robot, diagnostics}, of which there is what goes with the refusal.
[[nodiscard]] nlohmann::json to_json(const Refusal& refusal);

}  // namespace galilean::monitor
