// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/lease_json.h"

#include <algorithm>
#include <cmath>

namespace galilean::monitor {
namespace {

/// Returns the whole seconds that the holder has to answer, or null if nobody asks.
nlohmann::json answer_within_s(const LeaseDesk& desk, const Lease& lease) {
  if (lease.state() != LeaseState::kAsked) return nullptr;
  return static_cast<int>(std::ceil(std::max(to_seconds(lease.passes_at() - desk.now()), 0.0)));
}

nlohmann::json asker_json(const Lease& lease) {
  if (lease.state() != LeaseState::kAsked) return nullptr;
  return operator_json(lease.asker());
}

}  // namespace

nlohmann::json operator_json(const OperatorId& who) {
  return {{"name", who.name}, {"account", who.account}, {"client", who.client}};
}

nlohmann::json lease_json(const LeaseDesk& desk, const std::string& robot,
                          const OperatorId& viewer) {
  const Lease* lease = desk.find(robot);
  if (!lease || lease->state() == LeaseState::kFree) return nullptr;
  return {{"holder", operator_json(lease->holder())},
          {"since_s", to_seconds(desk.now() - lease->held_since())},
          {"asker", asker_json(*lease)},
          {"answer_within_s", answer_within_s(desk, *lease)},
          {"yours", lease->is_held_by(viewer)},
          {"asked_by_you", lease->is_asked_by(viewer)}};
}

nlohmann::json held_leases_json(const LeaseDesk& desk) {
  auto list = nlohmann::json::array();
  for (const auto& [robot, lease] : desk.leases())
    if (lease.state() != LeaseState::kFree)
      list.push_back({{"robot", robot},
                      {"holder", operator_json(lease.holder())},
                      {"asker", asker_json(lease)},
                      {"answer_within_s", answer_within_s(desk, lease)}});
  return list;
}

}  // namespace galilean::monitor
