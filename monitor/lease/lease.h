// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/clock.h"
#include "core/result.h"
#include "monitor/access/operator_id.h"
#include "monitor/lease/lease_change.h"

namespace galilean::monitor {

enum class LeaseState {
  kFree,   ///< whoever steers first gets it
  kHeld,   ///< one operator steers
  kAsked,  ///< another one asked the holder for it, and waits
};

/// What operators do with leases, besides steering.
enum class LeaseDeed { kAsk, kGive, kRefuse, kTake, kRelease };

/// Who may steer one robot. At most one operator holds it and at most one asks for it. An operator
/// is a person: whatever one of its tabs and processes may, the others may, too.
///
/// It has no clock of its own: every call says what time it is, and time never goes back. Call
/// `refresh` before every other call. Changes are added to `told`.
class Lease {
 public:
  /// A holder that says nothing for so long loses the lease.
  static constexpr Duration kSilence = std::chrono::seconds(10);
  /// Who asks gets the lease if the holder does not answer for so long.
  static constexpr Duration kAnswer = std::chrono::seconds(10);

  explicit Lease(std::string robot) : robot_(std::move(robot)) {}

  [[nodiscard]] const std::string& robot() const noexcept { return robot_; }
  [[nodiscard]] LeaseState state() const noexcept { return state_; }
  /// Requires: the state is not kFree.
  [[nodiscard]] const OperatorId& holder() const noexcept { return holder_.who; }
  /// Requires: the state is kAsked.
  [[nodiscard]] const OperatorId& asker() const noexcept { return asker_.who; }
  /// Returns when the holder got it. Requires: the state is not kFree.
  [[nodiscard]] Time held_since() const noexcept { return holder_.since; }
  /// Returns when the asker gets it unless it is answered. Requires: the state is kAsked.
  [[nodiscard]] Time passes_at() const noexcept { return asker_.since + kAnswer; }
  [[nodiscard]] bool is_held_by(const OperatorId& who) const noexcept {
    return state_ != LeaseState::kFree && holder_.who.is_same_person(who);
  }
  [[nodiscard]] bool is_asked_by(const OperatorId& who) const noexcept {
    return state_ == LeaseState::kAsked && asker_.who.is_same_person(who);
  }
  /// Returns whether `who` may steer now. A free robot may be steered by everybody.
  [[nodiscard]] bool may_steer(const OperatorId& who) const noexcept {
    return state_ == LeaseState::kFree || is_held_by(who);
  }

  /// Lets happen what was due until `now`: silence, and questions that were not answered.
  void refresh(Time now, std::vector<LeaseChange>& told);
  /// Notes a word of `who`, whatever it is about.
  void hear(const OperatorId& who, Time now);
  /// Gives a free lease to who steers. Requires: may_steer(who).
  void steer(const OperatorId& who, Time now, std::vector<LeaseChange>& told);
  /// Returns why `who` cannot do this now, in one sentence for them.
  [[nodiscard]] Result<void> check(LeaseDeed deed, const OperatorId& who,
                                   const std::string& reason) const;
  /// A release ends only what this tab or process alone has used. What several of one person have
  /// used ends with the silence of all of them.
  /// Requires: check() has no objection.
  void act(LeaseDeed deed, const OperatorId& who, const std::string& reason, Time now,
           std::vector<LeaseChange>& told);

 private:
  /// The holder or the asker.
  struct Party {
    OperatorId who;
    Time since{};  ///< it got the lease, or asked for it
    Time heard{};  ///< its last word
  };

  void ask(const OperatorId& who, const std::string& reason, Time now,
           std::vector<LeaseChange>& told);
  void take(const OperatorId& who, const std::string& reason, Time now,
            std::vector<LeaseChange>& told);
  void release(const OperatorId& who, Time now, std::vector<LeaseChange>& told);
  void pass_to_asker(Time now);
  void end_holding(Time now);
  void tell(LeaseChange::Kind kind, OperatorId by, OperatorId other, std::string reason, Time now,
            std::vector<LeaseChange>& told) const;

  std::string robot_;
  LeaseState state_ = LeaseState::kFree;
  Party holder_, asker_;
};

}  // namespace galilean::monitor
