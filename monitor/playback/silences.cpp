// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/playback/silences.h"

#include <algorithm>

#include "monitor/mcap/recording_time.h"

namespace galilean::monitor {

Silences::Silences(const std::vector<mcap::Block>& blocks) {
  edges_ns_.reserve(2 * blocks.size());
  for (const auto& block : blocks) {
    edges_ns_.push_back(block.start_ns);
    edges_ns_.push_back(block.end_ns);
  }
  std::ranges::sort(edges_ns_);
}

std::optional<std::uint64_t> Silences::end_of_silence_at(std::uint64_t from_ns) const {
  const auto next = std::ranges::upper_bound(edges_ns_, from_ns);
  if (next == edges_ns_.end() || *next - from_ns <= mcap::kLongestSilence_ns) return {};
  return *next;
}

bool Silences::between(std::uint64_t from_ns, std::uint64_t to_ns) const {
  if (to_ns <= from_ns || to_ns - from_ns <= mcap::kLongestSilence_ns) return false;
  const auto next = std::ranges::upper_bound(edges_ns_, from_ns);
  return next == edges_ns_.end() || *next >= to_ns;
}

}  // namespace galilean::monitor
