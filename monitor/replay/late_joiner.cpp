// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/late_joiner.h"

#include <algorithm>
#include <iterator>

namespace galilean::monitor {
namespace {

/// The number of events that a writer keeps for late joiners.
constexpr std::size_t kEventsKept = 64;

}  // namespace

void LateJoiner::keep(const mcap::Message& message, wire::Delivery delivery) {
  const bool is_event = delivery == wire::Delivery::kEvent;
  if (!is_event && delivery != wire::Delivery::kState) return;
  auto& kept = kept_[message.channel_id];
  if (kept.size() >= (is_event ? kEventsKept : 1)) kept.erase(kept.begin());
  kept.push_back({message, {message.data.begin(), message.data.end()}});
}

std::vector<LateJoiner::Kept> LateJoiner::in_order() {
  std::vector<Kept> all;
  for (auto& [channel, kept] : kept_) std::ranges::move(kept, std::back_inserter(all));
  kept_.clear();
  std::ranges::stable_sort(all, {}, [](const Kept& kept) { return kept.head.log_ns; });
  return all;
}

}  // namespace galilean::monitor
