// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/rerunning/recorded_inputs.h"

#include <set>
#include <string_view>

#include "core/spelling.h"
#include "core/visible_text.h"
#include "core/wire/neighbours.h"
#include "monitor/replay/report.h"
#include "monitor/replay/tracks.h"

namespace galilean::logs {
namespace {

/// Returns the robots whose inputs have a channel, of whatever release.
std::set<std::string> robots_with_inputs(const monitor::Tracks& tracks) {
  std::set<std::string> robots;
  for (const auto& [id, track] : tracks.inputs) robots.insert(wire::owner_of(track.topic));
  for (const auto& topic : tracks.foreign)
    if (topic.ends_with(kInputs)) robots.insert(wire::owner_of(topic));
  return robots;
}

Error without_inputs(const std::string& robot, const std::set<std::string>& known) {
  const std::vector<std::string_view> names(known.begin(), known.end());
  const auto meant = meant_name(robot, names);
  return {"no inputs of a robot '" + visible(robot) + "' are recorded" +
          (meant.empty() ? "; there are those of " + monitor::listed({known.begin(), known.end()})
                         : "; did you mean '" + visible(meant) + "'?")};
}

}  // namespace

Result<void> check_robots(const std::vector<std::string>& robots, const Recordings& recordings) {
  std::set<std::string> known;
  for (const auto& recording : recordings)
    known.merge(robots_with_inputs(monitor::tracks_of(recording->summary())));
  for (const auto& robot : robots)
    if (!known.empty() && !known.contains(robot)) return without_inputs(robot, known);
  return {};
}

}  // namespace galilean::logs
