// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace galilean {

/// Hands the newest T from one writer thread to one reader thread, wait-free on both sides:
/// three places, of which the writer owns one, the reader one, and the third is exchanged.
/// Places are made once; write into `writing()` in place where T is large.
template <class T>
class Latest {
 public:
  Latest() = default;
  explicit Latest(const T& initial) { places_.fill(initial); }

  /// Writer: the place to fill; holds an older value.
  [[nodiscard]] T& writing() noexcept { return places_[writing_]; }
  /// Writer: makes what stands in `writing()` the newest.
  void publish() noexcept {
    writing_ = exchanged_.exchange(static_cast<std::uint8_t>(writing_ | kFresh),
                                   std::memory_order_acq_rel) &
               kIndex;
  }
  void publish(const T& value) {
    writing() = value;
    publish();
  }

  /// Reader: takes the newest over; false if there was nothing new since the last call.
  bool take() noexcept {
    if (!(exchanged_.load(std::memory_order_relaxed) & kFresh)) return false;
    reading_ = exchanged_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  /// Reader: what was taken last.
  [[nodiscard]] const T& reading() const noexcept { return places_[reading_]; }

 private:
  static constexpr std::uint8_t kIndex = 3;
  static constexpr std::uint8_t kFresh = 4;

  std::array<T, 3> places_{};
  std::uint8_t writing_ = 0;
  std::atomic<std::uint8_t> exchanged_{1};
  std::uint8_t reading_ = 2;
};

}  // namespace galilean
