// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>

#include "core/clock.h"
#include "core/geometry.h"
#include "core/static_vector.h"

namespace galilean {

/// What something remembers from one tick to the next, in exact bits: either taken out of it, or
/// put into another of its kind. Each part is kept by one call of `keep`, which writes or reads, in
/// the same order. It neither allocates nor waits.
class Memory {
 public:
  /// Takes out of what calls `keep`, into `room`.
  [[nodiscard]] static Memory saving(std::span<std::uint64_t> room) noexcept {
    return {room.data(), nullptr, room.size()};
  }
  /// Puts `saved` into what calls `keep`.
  [[nodiscard]] static Memory loading(std::span<const std::uint64_t> saved) noexcept {
    return {nullptr, saved.data(), saved.size()};
  }

  /// Returns false once there was no more room, or nothing more that was saved.
  [[nodiscard]] bool fits() const noexcept { return fits_; }
  /// Returns how many words were written or read.
  [[nodiscard]] std::size_t words() const noexcept { return at_; }

  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void keep(T& value) noexcept {
    static_assert(sizeof(T) <= sizeof(std::uint64_t));
    std::uint64_t word = 0;
    std::memcpy(&word, &value, sizeof value);
    keep_word(word);
    if (to_) return;
    if constexpr (std::is_same_v<T, bool>)
      value = word != 0;
    else
      std::memcpy(&value, &word, sizeof value);
  }
  void keep(Duration& duration) noexcept {
    Duration::rep count = duration.count();
    keep(count);
    duration = Duration{count};
  }
  void keep(Time& time) noexcept {
    Duration since_start = time.time_since_epoch();
    keep(since_start);
    time = Time{since_start};
  }
  void keep(Vec2& vector) noexcept {
    keep(vector.x());
    keep(vector.y());
  }
  void keep(Mat2& matrix) noexcept {
    for (int i = 0; i < 4; ++i) keep(matrix(i / 2, i % 2));
  }
  void keep(Pose2& pose) noexcept {
    keep(pose.position_m);
    keep(pose.heading_rad);
  }
  template <class T>
  void keep(std::optional<T>& value) noexcept {
    bool there = value.has_value();
    keep(there);
    if (!to_ && there && !value) value.emplace();
    if (!there) return value.reset();
    keep(*value);
  }
  /// Keeps pixels, eight in a word.
  void keep(std::span<std::uint8_t> bytes) noexcept {
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
      const std::size_t size = std::min(sizeof(std::uint64_t), bytes.size() - at);
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data() + at, size);
      keep_word(word);
      if (!to_) std::memcpy(bytes.data() + at, &word, size);
    }
  }
  /// Keeps each element by `keep_one(memory, element)`.
  template <class T, std::size_t Capacity, class KeepOne>
  void keep(StaticVector<T, Capacity>& list, KeepOne keep_one) noexcept {
    std::size_t size = list.size();
    keep(size);
    if (!to_) {
      list.clear();
      while (list.size() < std::min(size, Capacity)) list.push_back(T{});
    }
    for (T& each : list) keep_one(*this, each);
  }

 private:
  Memory(std::uint64_t* to, const std::uint64_t* from, std::size_t size) noexcept
      : to_(to), from_(from), size_(size) {}

  void keep_word(std::uint64_t& word) noexcept {
    fits_ = fits_ && at_ < size_;
    if (!fits_) return;
    if (to_)
      to_[at_++] = word;
    else
      word = from_[at_++];
  }

  std::uint64_t* to_;
  const std::uint64_t* from_;
  std::size_t size_;
  std::size_t at_ = 0;
  bool fits_ = true;
};

}  // namespace galilean
