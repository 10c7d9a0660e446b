// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/wire/delivery.h"

namespace galilean::monitor {

/// Bounds what is kept of all topics: of states and events the newest messages stay, for those who
/// ask later. Whoever writes to DDS can write long messages on many topics.
class KeptBytes {
 public:
  static constexpr std::size_t kMost = std::size_t{512} << 20;
  /// A topic of which so much is kept does not count, so that robots in order always have room.
  static constexpr std::size_t kFree = std::size_t{64} << 10;

  /// Counts a message of `bytes` on a topic of which `of_topic` are counted until now, and updates
  /// that. Returns false, and counts nothing, if there is no room for it.
  [[nodiscard]] bool take(std::size_t& of_topic, wire::Delivery delivery, std::size_t bytes) {
    const std::size_t times = std::max<std::size_t>(1, wire::kept_for_late_joiners(delivery));
    const std::size_t kept = bytes > kMost / times ? kMost + 1 : bytes * times;
    const std::size_t counted = kept > kFree ? kept : 0;
    if (counted > 0 && all_ - of_topic + counted > kMost) return false;
    // Of events the longest counts for all that are kept of its topic.
    const std::size_t now =
        delivery == wire::Delivery::kEvent ? std::max(counted, of_topic) : counted;
    all_ = all_ - of_topic + now;
    of_topic = now;
    return true;
  }
  [[nodiscard]] std::size_t all() const noexcept { return all_; }

 private:
  std::size_t all_ = 0;
};

}  // namespace galilean::monitor
