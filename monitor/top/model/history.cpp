// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/history.h"

#include <algorithm>

#include "core/wire/messages.h"

namespace galilean::monitor::top {
namespace {

/// A grid is large, and changes slowly.
constexpr Duration kGridEach = std::chrono::seconds(10);

bool is_event(const Channel& channel) {
  return wire::is_event(channel.delivery);
}

Duration least_distance(const Channel& channel) {
  if (is_event(channel) || channel.schema->ros_type == msg::Program::kRosType) return {};
  return channel.schema->ros_type == msg::OccupancyGrid::kRosType ? kGridEach : History::kEach;
}

}  // namespace

void History::note(const Message& message) {
  auto at = tracks_.find(message.channel.topic);
  if (at == tracks_.end())
    at = tracks_.emplace(message.channel.topic, Track{message.channel, {}}).first;
  auto& samples = at->second.samples;
  const Time now = clock_.now();
  if (!samples.empty() && now - samples.back().received < least_distance(message.channel)) return;
  samples.push_back({now, message.received_ns, message.sent_ns, message.cdr, message.replayed});
  if (is_event(message.channel)) {
    if (samples.size() > kEventsKept) samples.pop_front();
    return;
  }
  while (samples.size() > 1 && now - samples.front().received > kKept) samples.pop_front();
}

Time History::begin() const {
  Time first = clock_.now();
  for (const auto& [topic, track] : tracks_)
    if (!is_event(track.channel)) first = std::min(first, track.samples.front().received);
  return std::max(first, clock_.now() - kKept);
}

std::vector<History::Sample> History::until(const std::string& topic, Time then,
                                            std::size_t most) const {
  const auto found = tracks_.find(topic);
  if (found == tracks_.end()) return {};
  const auto& samples = found->second.samples;
  const auto end = std::upper_bound(samples.begin(), samples.end(), then,
                                    [](Time time, const Sample& s) { return time < s.received; });
  const auto count =
      std::min<std::ptrdiff_t>(end - samples.begin(), static_cast<std::ptrdiff_t>(most));
  return {end - count, end};
}

}  // namespace galilean::monitor::top
