// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <utility>

namespace galilean::monitor {

/// Changes of the history that its disk has not taken yet, in the order in which they are to be
/// written. Each has a key, and a newer change takes the place of an older one of the same key. For
/// use by one thread.
class OwedChanges {
 public:
  /// As many are kept. Where there are more, the oldest is lost.
  static constexpr std::size_t kMost = 1024;
  using Change = std::function<void()>;

  void add(const std::string& key, Change change) {
    std::erase_if(changes_, [&](const auto& each) { return each.first == key; });
    changes_.emplace_back(key, std::move(change));
    if (changes_.size() <= kMost) return;
    changes_.pop_front();
    ++lost_;
  }
  [[nodiscard]] bool empty() const noexcept { return changes_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return changes_.size(); }
  /// Requires: not empty().
  [[nodiscard]] const Change& oldest() const { return changes_.front().second; }
  /// Requires: not empty().
  void drop_oldest() { changes_.pop_front(); }
  /// Returns how many were lost, because there were more than kMost.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }

 private:
  std::deque<std::pair<std::string, Change>> changes_;
  std::uint64_t lost_ = 0;
};

}  // namespace galilean::monitor
