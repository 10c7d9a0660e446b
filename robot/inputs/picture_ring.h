// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "core/device/frame.h"

namespace galilean::robot {

/// A queue of pictures from one writer thread to one reader thread, which are written and read in
/// place. Neither thread waits. The places are made once.
class PictureRing {
 public:
  explicit PictureRing(std::size_t places) : places_(places) {}

  /// Writer: returns the place of the next picture, or null if the queue is full.
  [[nodiscard]] Frame* writing() noexcept {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    const bool full = end - begin_.load(std::memory_order_acquire) == places_.size();
    return full ? nullptr : &places_[end % places_.size()];
  }
  /// Writer: appends what stands in `writing()`. Requires: that was not null.
  void publish() noexcept { end_.fetch_add(1, std::memory_order_release); }

  /// Reader: returns the oldest picture, or null if there is none.
  [[nodiscard]] const Frame* oldest() const noexcept {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    const bool empty = begin == end_.load(std::memory_order_acquire);
    return empty ? nullptr : &places_[begin % places_.size()];
  }
  /// Reader: gives its place back. Requires: there is one.
  void release() noexcept { begin_.fetch_add(1, std::memory_order_release); }

 private:
  std::vector<Frame> places_;
  std::atomic<std::size_t> begin_{0};
  std::atomic<std::size_t> end_{0};
};

}  // namespace galilean::robot
