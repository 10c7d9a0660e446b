// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/team_parameters.h"

#include "monitor/server/api/lease_json.h"

namespace galilean::monitor {
namespace {
constexpr std::string_view kHeld = ".held";

/// Returns by robot which transitions fill a gap, as ranges of their numbers.
nlohmann::json filled_json(const Team& team) {
  auto json = nlohmann::json::object();
  for (const auto& [name, robot] : team.robots())
    for (const auto& range : robot.filled)
      json[name].push_back(nlohmann::json::array({range.first, range.last}));
  return json;
}

}  // namespace

foxglove::ParameterValues team_parameters(const Team& team, const LeaseDesk& leases) {
  foxglove::ParameterValues values{{"/team.program_hash", team.program_hash()},
                                   {"/team.replayed", team.replayed()},
                                   {"/team.filled", filled_json(team)},
                                   {"/team.leases", held_leases_json(leases)}};
  for (const auto& robot : team.statuses()) {
    const auto prefix = "/" + robot.name + ".";
    values[prefix + "held"] = robot.held;
    values[prefix + "program_hash"] = robot.program_hash;
    values[prefix + "program_name"] = robot.program_name;
  }
  return values;
}

void set_team_parameter(Operations& operations, const foxglove::Parameter& wanted,
                        const OperatorId& who, foxglove::Hub::Answer answer) {
  if (!wanted.name.ends_with(kHeld) || !wanted.value.is_boolean())
    return answer(Error{wanted.name + " cannot be set: /NAME.held can, to true or false."});
  const auto robot = wanted.name.substr(1, wanted.name.size() - 1 - kHeld.size());
  operations.command({{"kind", wanted.value.get<bool>() ? "hold" : "resume"}, {"targets", {robot}}},
                     who, [answer = std::move(answer)](const Outcome& outcome) {
                       if (outcome.status < 400) return answer(outcome.json);
                       answer(Error{outcome.detail});
                     });
}

}  // namespace galilean::monitor
