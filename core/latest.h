// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace galilean {

/// Hands the newest T from one writer thread to one reader thread. Neither thread waits. There are
/// three places: the writer owns one, the reader owns one, and both exchange theirs for the third
/// (triple buffering). The places are made once. A large T is best written in place, in
/// `writing()`.
template <class T>
class Latest {
 public:
  Latest() = default;
  explicit Latest(const T& initial) { places_.fill(initial); }

  /// Writer: returns the place to fill. It holds an older value.
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

  /// Reader: takes the newest value over. Returns false if nothing was published since the last
  /// call.
  bool take() noexcept {
    if (!(exchanged_.load(std::memory_order_relaxed) & kFresh)) return false;
    reading_ = exchanged_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  /// Reader: returns the value that was taken last.
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
