// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/past.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace galilean::monitor::top {

Past::Past(const History& history, Time instant) {
  std::vector<std::pair<const Channel*, History::Sample>> samples;
  for (const auto& [topic, track] : history.tracks()) {
    const bool is_event = wire::is_event(track.channel.delivery);
    for (auto& sample : history.until(topic, instant, is_event ? History::kEventsKept : 1))
      samples.emplace_back(&track.channel, std::move(sample));
  }
  std::ranges::stable_sort(samples, {}, [](const auto& each) { return each.second.received; });
  for (const auto& [channel, sample] : samples) {
    clock_.advance(sample.received - clock_.now());
    model_.receive({*channel, sample.received_ns, sample.sent_ns, sample.cdr, sample.replayed});
  }
  clock_.advance(instant - clock_.now());
}

}  // namespace galilean::monitor::top
