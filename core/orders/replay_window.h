// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>

namespace galilean {

/// Remembers the numbers of one signer's orders, so that none is carried out twice. DDS may bring
/// orders of several processes in another order than that of their numbers: the window keeps the
/// highest numbers that came, and refuses what is older than all of them.
class ReplayWindow {
 public:
  static constexpr std::size_t kKept = 1024;

  /// Returns whether an order of this number may have come already.
  [[nodiscard]] bool has(std::uint64_t number) const {
    return number <= floor_ || numbers_.contains(number);
  }
  /// Remembers a number. Requires: has() returned false for it.
  void add(std::uint64_t number) {
    numbers_.insert(number);
    if (numbers_.size() <= kKept) return;
    floor_ = *numbers_.begin();
    numbers_.erase(numbers_.begin());
  }

 private:
  std::uint64_t floor_ = 0;  ///< whatever is not above it counts as known
  std::set<std::uint64_t> numbers_;
};

}  // namespace galilean
