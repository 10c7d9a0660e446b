// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>

namespace galilean::robot {

/// A queue from one writer thread to one reader thread. Neither thread waits. The items are stored
/// inside the object.
template <class T, std::size_t Capacity>
class SpscRing {
 public:
  /// Writer: appends an item. Returns false, and appends nothing, when the queue is full.
  bool push(T item) noexcept {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == Capacity) return false;
    items_[end % Capacity] = std::move(item);
    end_.store(end + 1, std::memory_order_release);
    return true;
  }

  /// Reader: takes the oldest item. Returns nothing if the queue is empty.
  std::optional<T> pop() noexcept {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    if (begin == end_.load(std::memory_order_acquire)) return std::nullopt;
    std::optional<T> item = std::move(items_[begin % Capacity]);
    begin_.store(begin + 1, std::memory_order_release);
    return item;
  }

 private:
  std::array<T, Capacity> items_{};
  std::atomic<std::size_t> begin_{0};
  std::atomic<std::size_t> end_{0};
};

}  // namespace galilean::robot
