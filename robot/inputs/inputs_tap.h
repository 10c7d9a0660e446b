// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "robot/executive/spsc_ring.h"
#include "robot/executive/tick_observer.h"
#include "robot/inputs/outcome_digests.h"
#include "robot/inputs/picture_ring.h"
#include "robot/inputs/tick_record.h"

namespace galilean::robot {

/// Hands what each tick read from outside, and what it led to, from the control loop to the one
/// thread that publishes it. Neither thread waits, and the control loop copies into memory that was
/// made before. Ticks for which there is no room are counted.
class InputsTap final : public TickObserver {
 public:
  /// Three seconds of a robot that ticks twenty times a second and sees five pictures a second.
  static constexpr std::size_t kMostTicks = 64;
  static constexpr std::size_t kMostPictures = 16;
  /// What an executive may remember: a megabyte, of which four images take a quarter.
  static constexpr std::size_t kMostWords = std::size_t{1} << 17;

  /// Ticks are wanted from the first one on.
  InputsTap() : pictures_(kMostPictures), memory_(kMostWords) {}

  void on_event(const Event& event) noexcept override;
  void on_tick(const TickView& view) noexcept override;

  /// Reader: sets whether ticks are handed over.
  void want(bool wanted) noexcept { wanted_.store(wanted, std::memory_order_relaxed); }
  /// Reader: takes the oldest tick over. Returns false if there is none.
  [[nodiscard]] bool take(TickRecord& to);
  /// Reader: returns the picture of the tick that was taken last. Requires: it has one. It stays
  /// until the next `take`.
  [[nodiscard]] const Frame& picture() const noexcept { return *pictures_.oldest(); }
  /// Reader: asks for all that the executive remembers at the end of the next tick.
  void want_memory() noexcept { wants_memory_.store(true, std::memory_order_relaxed); }
  /// Reader: returns it for the tick that was taken last. Requires: it has it. It stays until the
  /// next `take`.
  [[nodiscard]] std::span<const std::uint64_t> memory() const noexcept {
    return std::span(memory_).first(taken_words_);
  }
  /// Any thread. Returns how many ticks were lost because the reader did not take older ones in
  /// time.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_.load(); }

 private:
  void copy(const TickView& view) noexcept;
  void copy_memory(const TickView& view) noexcept;
  [[nodiscard]] bool hand_over_picture(const Frame& frame) noexcept;
  void begin_anew() noexcept;

  std::atomic<bool> wanted_{true};
  std::atomic<bool> wants_memory_{false};
  std::atomic<bool> memory_is_free_{true};  ///< for the control loop to write
  std::atomic<std::uint64_t> lost_{0};
  SpscRing<TickRecord, kMostTicks> records_;
  PictureRing pictures_;
  std::vector<std::uint64_t> memory_;
  TickRecord next_;               ///< control: of this tick
  OutcomeDigests outcome_;        ///< control
  std::uint64_t last_frame_ = 0;  ///< control: the newest that was handed over
  bool holds_picture_ = false;    ///< reader: that of the tick that was taken last
  std::size_t taken_words_ = 0;   ///< reader: of the memory of the tick that was taken last
};

}  // namespace galilean::robot
