// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/stage.h"

#include "core/wire/topic_names.h"

namespace galilean::monitor {
namespace {

bool monitor_is_in(const wire::Graph::Topics& topics) {
  const auto objects = topics.find(wire::kObjectsTopic);
  return objects != topics.end() && objects->second.writers.contains(wire::kMonitorName);
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

}  // namespace galilean::monitor
