// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "core/geometry.h"
#include "core/memory.h"

namespace galilean {

/// One stream of random numbers, the same on every machine for the same seed
/// (xoshiro256**, Blackman and Vigna 2018, seeded by splitmix64).
/// Everything random descends from one seed by `child`, so that a new consumer disturbs no other.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept;

  /// Returns a new stream for `name`. It does not depend on how much was drawn from this one.
  [[nodiscard]] Random child(std::string_view name) const noexcept;

  [[nodiscard]] std::uint64_t bits() noexcept;
  /// Returns a number in [0, 1).
  [[nodiscard]] double uniform() noexcept;
  /// Returns a number in [low, high).
  [[nodiscard]] double uniform(double low, double high) noexcept;
  /// Returns a whole number in [0, count).
  [[nodiscard]] std::uint32_t below(std::uint32_t count) noexcept;
  /// Returns a normally distributed number with mean 0 and standard deviation 1.
  [[nodiscard]] double normal() noexcept;
  /// Returns a unit vector. Every heading is equally likely.
  [[nodiscard]] Vec2 heading() noexcept;

  void keep(Memory& memory) noexcept {
    memory.keep(seed_);
    for (std::uint64_t& word : state_) memory.keep(word);
  }

 private:
  std::uint64_t seed_;
  std::uint64_t state_[4];
};

}  // namespace galilean
