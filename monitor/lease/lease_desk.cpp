// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/lease/lease_desk.h"

#include <utility>

namespace galilean::monitor {
namespace {

/// Returns "io", "io and callisto", "io, ganymede and callisto".
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

}  // namespace

void LeaseDesk::hear(const OperatorId& who) {
  refresh();
  for (auto& [robot, lease] : leases_) lease.hear(who, clock_.now());
}

Result<void> LeaseDesk::admit(OrderKind kind, const OperatorId& who, const Robots& robots) {
  hear(who);
  if (kind == OrderKind::kStops) return {};
  if (auto may = check_steering(who, robots); !may) return may;
  for (const auto& robot : robots) lease_of(robot).steer(who, clock_.now(), changes_);
  return {};
}

Result<void> LeaseDesk::act(LeaseDeed deed, const OperatorId& who, const Robots& robots,
                            const std::string& reason) {
  hear(who);
  for (const auto& robot : robots)
    if (auto may = lease_of(robot).check(deed, who, reason); !may) return may;
  for (const auto& robot : robots)
    // A robot that is named twice was done at the first time.
    if (Lease& lease = lease_of(robot); lease.check(deed, who, reason))
      lease.act(deed, who, reason, clock_.now(), changes_);
  return {};
}

void LeaseDesk::refresh() {
  for (auto& [robot, lease] : leases_) lease.refresh(clock_.now(), changes_);
}

std::vector<LeaseChange> LeaseDesk::take_changes() {
  return std::exchange(changes_, {});
}

const Lease* LeaseDesk::find(const std::string& robot) const {
  const auto found = leases_.find(robot);
  return found == leases_.end() ? nullptr : &found->second;
}

LeaseDesk::Robots LeaseDesk::robots_of(const OperatorId& who) const {
  Robots robots;
  for (const auto& [robot, lease] : leases_)
    if (lease.is_held_by(who) || lease.is_asked_by(who)) robots.push_back(robot);
  return robots;
}

Lease& LeaseDesk::lease_of(const std::string& robot) {
  return leases_.try_emplace(robot, robot).first->second;
}

Result<void> LeaseDesk::check_steering(const OperatorId& who, const Robots& robots) const {
  std::map<std::string, Robots> held;  // by the holder's name
  std::size_t count = 0;
  for (const auto& robot : robots) {
    const Lease* lease = find(robot);
    if (!lease || lease->may_steer(who)) continue;
    held[lease->holder().name].push_back(robot);
    ++count;
  }
  if (held.empty()) return {};
  std::string who_holds;
  for (const auto& [holder, theirs] : held)
    who_holds += (who_holds.empty() ? "" : ", ") + holder + " holds " + listed(theirs);
  return Error{"Nothing was done: " + who_holds +
               (count == 1 ? ". Ask for it, or take it over with a reason."
                           : ". Ask for them, or take them over with a reason.")};
}

}  // namespace galilean::monitor
