// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/trial_room.h"

#include <unistd.h>

#include "monitor/trial/situation.h"

namespace galilean::monitor {

void TrialRoom::receive(const Message& message) {
  if (message.channel.schema->ros_type == msg::ObjectMap::kRosType) newest_map_ = message.cdr;
}

std::optional<msg::ObjectMap> TrialRoom::map() const {
  msg::ObjectMap map;
  if (!newest_map_ || !msg::decode_cdr(*newest_map_, map)) return std::nullopt;
  return map;
}

std::vector<bhdl::SourceFile> TrialRoom::running(const std::vector<std::string>& robots) const {
  for (const auto& name : robots) {
    const Robot* robot = team_.find(name);
    if (!robot || !robot->program) continue;
    std::vector<bhdl::SourceFile> files;
    for (const auto& file : robot->program->files) files.push_back({file.path, file.text});
    return files;
  }
  return {};
}

Result<std::unique_ptr<Trial>> TrialRoom::begin(const std::string& id, const TryProgram& what,
                                                Trial::Done done) const {
  if (access(simulator_.c_str(), X_OK) != 0)
    return Error{"the simulator " + simulator_.string() +
                 " is not there; install it, or push without a trial"};
  auto situation = situation_of(team_, map());
  if (!situation) return situation.error();
  std::string scenario = what.options.scenario;
  if (scenario.empty() && team_.score()) scenario = team_.score()->scenario;
  if (scenario.empty())
    return Error{"no referee says in which arena the team is; name the arena's scenario"};
  return std::make_unique<Trial>(io_, simulator_, folder_ / id,
                                 TrialOrder{.next = what.files,
                                            .now = running(what.robots),
                                            .situation = std::move(situation).value(),
                                            .scenario = std::move(scenario),
                                            .seeds = what.options.seeds,
                                            .duration_s = what.options.duration_s},
                                 std::move(done));
}

}  // namespace galilean::monitor
