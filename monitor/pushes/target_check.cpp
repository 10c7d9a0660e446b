// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/target_check.h"

#include <random>
#include <set>

#include "core/wire/messages.h"
#include "core/wire/ros_time.h"

namespace galilean::monitor {

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
  return check_for(targets, library.catalog(),
                   [&](const Catalog& catalog) { return library.check(files, catalog); });
}

msg::ProgramPush make_push(const bhdl::Program& program, const std::string& author,
                           const std::vector<std::string>& targets,
                           const std::string& replaces_hash) {
  msg::ProgramPush push;
  push.stamp = wire::ros_time(wire::wall_clock_ns());
  push.id = new_id();
  push.author = author;
  push.targets = targets;
  push.replaces_hash = replaces_hash;
  push.hash = program.hash;
  for (const auto& file : program.files) push.files.push_back({file.path, file.text});
  return push;
}

std::string new_id() {
  std::random_device entropy;
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string id;
  for (int word = 0; word < 4; ++word)
    for (unsigned bits = entropy(), i = 0; i < 8; ++i, bits >>= 4) id += kDigits[bits & 15];
  return id;
}

}  // namespace galilean::monitor
