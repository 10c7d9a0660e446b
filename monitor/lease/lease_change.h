// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "core/clock.h"
#include "monitor/access/operator_id.h"

namespace galilean::monitor {

/// One change of a robot's lease, as all operators are told it.
struct LeaseChange {
  enum class Kind {
    kTaken,       ///< `by` steers a robot that nobody held
    kAsked,       ///< `by` asks `other`, the holder, for it
    kGiven,       ///< `by` gives it to `other`, who asked
    kRefused,     ///< `by` keeps it, and says so to `other`, who asked
    kTakenOver,   ///< `by` takes it from `other`, with a reason
    kUnanswered,  ///< `by` gets it, because `other` did not answer
    kReleased,    ///< `by` lets it go; `other`, who had asked, gets it, if somebody had
    kWithdrawn,   ///< `by` does not ask `other` any more
    kSilent,  ///< `by` held it and says nothing any more; `other` gets it, if somebody had asked
  };
  Kind kind = Kind::kTaken;
  std::string robot;
  OperatorId by, other;  ///< the name is empty where there is none
  std::string reason;    ///< as `by` wrote it; mostly empty
  Time at{};
  std::string holder, asker;  ///< names after the change; empty: none
};

/// Returns the kind as a message has it, such as "taken_over".
[[nodiscard]] std::string_view name_of(LeaseChange::Kind kind) noexcept;
/// Returns the change in words that follow the robot's name, without a full stop: "ada took it over
/// from ben: it stands in the door".
[[nodiscard]] std::string in_words(const LeaseChange& change);

}  // namespace galilean::monitor
