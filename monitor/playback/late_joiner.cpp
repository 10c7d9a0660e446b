// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/playback/late_joiner.h"

#include <algorithm>
#include <iterator>

namespace galilean::monitor {

void LateJoiner::keep(const mcap::Message& message, wire::Delivery delivery) {
  const auto most = wire::kept_for_late_joiners(delivery);
  if (most == 0) return;
  auto& kept = kept_[message.channel_id];
  if (kept.size() >= most) kept.erase(kept.begin());
  kept.push_back(mcap::OwnedMessage::of(message));
}

std::vector<mcap::OwnedMessage> LateJoiner::in_order() {
  std::vector<mcap::OwnedMessage> all;
  for (auto& [channel, kept] : kept_) std::ranges::move(kept, std::back_inserter(all));
  kept_.clear();
  std::ranges::stable_sort(all, {},
                           [](const mcap::OwnedMessage& kept) { return kept.head.log_ns; });
  return all;
}

}  // namespace galilean::monitor
