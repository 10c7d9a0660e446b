// SPDX-License-Identifier: BSD-3-Clause
// Who may steer which robot, as operators ask for it.
#include <algorithm>
#include <map>

#include "core/cut_text.h"
#include "core/visible_text.h"
#include "monitor/server/api/lease_json.h"
#include "monitor/server/api/operations.h"
#include "monitor/server/text/request_fields.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kMostReasonBytes = 200;

const std::map<std::string, LeaseDeed>& lease_deeds() {
  static const std::map<std::string, LeaseDeed> kDeeds{{"ask", LeaseDeed::kAsk},
                                                       {"give", LeaseDeed::kGive},
                                                       {"refuse", LeaseDeed::kRefuse},
                                                       {"take", LeaseDeed::kTake},
                                                       {"release", LeaseDeed::kRelease}};
  return kDeeds;
}

nlohmann::json leases_of(const LeaseDesk& desk, const std::vector<std::string>& robots,
                         const OperatorId& who) {
  auto leases = nlohmann::json::object();
  for (const auto& robot : robots) leases[robot] = lease_json(desk, robot, who);
  return leases;
}

/// Returns a reason as all operators are shown it.
std::string shown_reason(const std::string& text) {
  return std::string(cut_text(visible(cut_text(text, kMostReasonBytes)), kMostReasonBytes));
}

}  // namespace

void Operations::change_lease(const nlohmann::json& request, const OperatorId& who, Finish finish) {
  RequestFields fields(request);
  const auto deed = lease_deeds().find(fields.text("do"));
  auto robots = fields.names("robots");
  const auto reason = shown_reason(fields.text("reason"));
  if (deed == lease_deeds().end())
    fields.refuse("'do' must be ask, give, refuse, take or release.");
  else if (robots.empty() && deed->second != LeaseDeed::kRelease)
    fields.refuse("'robots' must name one robot or more.");
  if (!fields.ok()) return finish({400, {}, fields.objection()});
  for (const auto& robot : robots)
    if (!parts_.team.find(robot)) return finish({404, {}, "There is no robot '" + robot + "'."});
  if (robots.empty()) robots = parts_.leases.robots_of(who);
  const auto done = parts_.leases.act(deed->second, who, robots, reason);
  const nlohmann::json answer{{"leases", leases_of(parts_.leases, robots, who)}};
  finish(done ? Outcome{200, answer} : Outcome{409, answer, done.error().message});
}

bool Operations::admits(OrderKind kind, const OperatorId& who,
                        const std::vector<std::string>& targets, const Finish& finish) {
  const auto robots = targets.empty() ? team_now() : targets;
  const auto may = parts_.leases.admit(kind, who, robots);
  if (!may) finish({409, {{"leases", leases_of(parts_.leases, robots, who)}}, may.error().message});
  return may.ok();
}

std::vector<std::string> Operations::team_now() const {
  std::vector<std::string> names;
  for (const auto& [name, robot] : parts_.team.robots())
    if (!parts_.team.replayed(robot)) names.push_back(name);
  return names;
}

}  // namespace galilean::monitor
