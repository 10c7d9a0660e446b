// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/target_check.h"

#include <set>

namespace galilean::monitor {

bool takes_what_all_take(const Robot& robot, const Team& team) {
  return !(robot.state && robot.state->out_of_service) && !team.replayed(robot);
}

TargetCheck check_for(const std::vector<Target>& targets, const Catalog& installed,
                      const std::function<bhdl::CheckResult(const Catalog&)>& check) {
  if (targets.empty()) return {check(installed), {}};
  TargetCheck result;
  std::set<std::string> checked;
  for (const auto& target : targets) {
    if (!checked.insert(target.catalog ? target.catalog->hash : std::string()).second) continue;
    auto own = target.catalog ? catalog_from_json(target.catalog->json) : Result(installed);
    auto found = check(own ? own.value() : installed);
    const bool refused = !found.program;
    if (refused || checked.size() == 1) result.result = std::move(found);
    if (!refused) continue;
    result.refused_by = target.robot;
    break;
  }
  return result;
}

TargetCheck check_for(const std::vector<bhdl::SourceFile>& files,
                      const std::vector<Target>& targets, const ProgramLibrary& library) {
  auto found = check_for(targets, library.catalog(),
                         [&](const Catalog& catalog) { return library.check(files, catalog); });
  found.taken = library.taken(files, found.result);
  return found;
}

}  // namespace galilean::monitor
