// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/lease/lease.h"

namespace galilean::monitor {

using Kind = LeaseChange::Kind;

void Lease::refresh(Time now, std::vector<LeaseChange>& told) {
  // Each round gives the lease to the asker or frees it, so that there are two at most.
  while (state_ != LeaseState::kFree) {
    const Time silent_at = holder_.heard + kSilence;
    const bool is_asked = state_ == LeaseState::kAsked;
    if (is_asked && passes_at() <= now && passes_at() <= silent_at) {
      const Time at = passes_at();
      const OperatorId before = holder_.who;
      pass_to_asker(at);
      tell(Kind::kUnanswered, holder_.who, before, {}, at, told);
    } else if (silent_at <= now) {
      const OperatorId before = holder_.who;
      end_holding(silent_at);
      tell(Kind::kSilent, before, is_asked ? holder_.who : OperatorId{}, {}, silent_at, told);
    } else {
      return;
    }
  }
}

void Lease::hear(const OperatorId& who, Time now) {
  if (is_held_by(who)) holder_.heard = now;
  if (is_asked_by(who)) asker_.heard = now;
}

void Lease::steer(const OperatorId& who, Time now, std::vector<LeaseChange>& told) {
  if (state_ != LeaseState::kFree) {
    // Tabs or processes share it from now on, so that none of them lets go what another one uses.
    if (holder_.who.client != who.client) holder_.who.client.clear();
    holder_.heard = now;
    return;
  }
  state_ = LeaseState::kHeld;
  holder_ = {who, now, now};
  tell(Kind::kTaken, who, {}, {}, now, told);
}

Result<void> Lease::check(LeaseDeed deed, const OperatorId& who, const std::string& reason) const {
  switch (deed) {
    case LeaseDeed::kAsk:
      if (state_ == LeaseState::kAsked && !is_held_by(who) && !is_asked_by(who))
        return Error{asker_.who.name + " has asked " + holder_.who.name + " for " + robot_ +
                     " already; wait until that is answered."};
      return {};
    case LeaseDeed::kGive:
    case LeaseDeed::kRefuse:
      if (state_ == LeaseState::kFree) return Error{"Nobody holds " + robot_ + "."};
      if (!is_held_by(who))
        return Error{holder_.who.name + " holds " + robot_ + ", and answers who asks for it."};
      if (state_ != LeaseState::kAsked) return Error{"Nobody asks for " + robot_ + "."};
      return {};
    case LeaseDeed::kTake:
      if (!may_steer(who) && reason.empty())
        return Error{holder_.who.name + " holds " + robot_ +
                     ": say with 'reason' why you take it over. All operators see it."};
      return {};
    case LeaseDeed::kRelease:
      return {};
  }
  return {};
}

void Lease::act(LeaseDeed deed, const OperatorId& who, const std::string& reason, Time now,
                std::vector<LeaseChange>& told) {
  switch (deed) {
    case LeaseDeed::kAsk:
      return ask(who, reason, now, told);
    case LeaseDeed::kGive:
      pass_to_asker(now);
      return tell(Kind::kGiven, who, holder_.who, reason, now, told);
    case LeaseDeed::kRefuse:
      state_ = LeaseState::kHeld;
      return tell(Kind::kRefused, who, asker_.who, reason, now, told);
    case LeaseDeed::kTake:
      return take(who, reason, now, told);
    case LeaseDeed::kRelease:
      return release(who, now, told);
  }
}

void Lease::ask(const OperatorId& who, const std::string& reason, Time now,
                std::vector<LeaseChange>& told) {
  if (may_steer(who)) return steer(who, now, told);
  if (is_asked_by(who)) {
    asker_.heard = now;  // to ask again does not begin the time again
    return;
  }
  state_ = LeaseState::kAsked;
  asker_ = {who, now, now};
  tell(Kind::kAsked, who, holder_.who, reason, now, told);
}

void Lease::take(const OperatorId& who, const std::string& reason, Time now,
                 std::vector<LeaseChange>& told) {
  if (may_steer(who)) return steer(who, now, told);
  const OperatorId before = holder_.who;
  state_ = LeaseState::kHeld;  // whoever asked the holder before asks nobody now
  holder_ = {who, now, now};
  tell(Kind::kTakenOver, who, before, reason, now, told);
}

void Lease::release(const OperatorId& who, Time now, std::vector<LeaseChange>& told) {
  if (is_asked_by(who) && asker_.who.client == who.client) {
    state_ = LeaseState::kHeld;
    return tell(Kind::kWithdrawn, who, holder_.who, {}, now, told);
  }
  if (!is_held_by(who) || holder_.who.client != who.client) return;
  const bool is_asked = state_ == LeaseState::kAsked;
  end_holding(now);
  tell(Kind::kReleased, who, is_asked ? holder_.who : OperatorId{}, {}, now, told);
}

void Lease::end_holding(Time now) {
  if (state_ == LeaseState::kAsked)
    pass_to_asker(now);
  else
    state_ = LeaseState::kFree;
}

void Lease::pass_to_asker(Time now) {
  holder_ = {asker_.who, now, asker_.heard};
  state_ = LeaseState::kHeld;
}

void Lease::tell(LeaseChange::Kind kind, OperatorId by, OperatorId other, std::string reason,
                 Time now, std::vector<LeaseChange>& told) const {
  LeaseChange change{.kind = kind,
                     .robot = robot_,
                     .by = std::move(by),
                     .other = std::move(other),
                     .reason = std::move(reason),
                     .at = now,
                     .holder = {},
                     .asker = {}};
  if (state_ != LeaseState::kFree) change.holder = holder_.who.name;
  if (state_ == LeaseState::kAsked) change.asker = asker_.who.name;
  told.push_back(std::move(change));
}

}  // namespace galilean::monitor
