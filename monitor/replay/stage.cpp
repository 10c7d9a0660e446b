// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/stage.h"

#include <set>

#include "core/wire/discovery.h"
#include "core/wire/topic_names.h"

namespace galilean::monitor {
namespace {

bool monitor_is_in(const wire::Graph::Topics& topics) {
  const auto objects = topics.find(wire::kObjectsTopic);
  return objects != topics.end() && objects->second.writers.contains(wire::kMonitorName);
}

/// Returns the robot's name in a topic: "io" for "rt/io/state".
std::string owner(const std::string& topic) {
  const auto name = topic.substr(topic.find('/') + 1);
  return name.substr(0, name.find('/'));
}

}  // namespace

Stage::Stage(wire::Participant& participant, const std::map<std::uint16_t, Track>& tracks)
    : participant_(participant), tracks_(tracks), graph_(participant) {
  look();
}

void Stage::look() {
  has_monitor_ = monitor_is_in(graph_.topics());
  for (const auto& [channel, track] : tracks_) {
    if (has_monitor_ && is_made_by_monitor(track))
      writers_.erase(key_of(track));
    else if (!writers_.contains(key_of(track)))
      writers_.emplace(key_of(track), wire::ByteWriter(participant_, track.topic, track.ros_type));
  }
}

void Stage::send(std::uint16_t channel, std::span<const std::uint8_t> cdr) {
  const auto track = tracks_.find(channel);
  if (track == tracks_.end()) return;
  const auto writer = writers_.find(key_of(track->second));
  if (writer != writers_.end() && !writer->second.write(cdr)) ++lost_;
}

std::vector<std::string> live_namesakes(const std::vector<wire::Publication>& publications,
                                        const std::map<std::uint16_t, Track>& tracks) {
  std::set<std::string> played, names;
  for (const auto& [channel, track] : tracks)
    if (!is_shared(track) && !is_made_by_monitor(track)) played.insert(track.topic);
  for (const auto& publication : publications)
    if (played.contains(publication.topic)) names.insert(owner(publication.topic));
  return {names.begin(), names.end()};
}

}  // namespace galilean::monitor
