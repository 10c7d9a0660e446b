// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "monitor/lease/lease_desk.h"

namespace galilean::monitor {

/// Returns {name, account, client}.
[[nodiscard]] nlohmann::json operator_json(const OperatorId& who);
/// Returns a robot's lease as docs/openapi.yaml describes it, or null if nobody holds it. `viewer`
/// is who asks: the members "yours" and "asked_by_you" are about them.
[[nodiscard]] nlohmann::json lease_json(const LeaseDesk& desk, const std::string& robot,
                                        const OperatorId& viewer);
/// Returns the leases that somebody holds, as the page is told them when they change: a list of
/// {robot, holder, asker, answer_within_s} in the robots' order. The time is in whole seconds, so
/// that it changes once a second at most.
[[nodiscard]] nlohmann::json held_leases_json(const LeaseDesk& desk);

}  // namespace galilean::monitor
