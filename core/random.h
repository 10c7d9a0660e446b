// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "core/geometry.h"

namespace galilean {

/// One stream of random numbers, the same on every machine for the same seed
/// (xoshiro256**, Blackman and Vigna 2018, seeded by splitmix64).
/// Everything random descends from one seed by `child`, so that a new consumer disturbs no other.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept;

  /// A stream of its own for `name`, independent of how much was drawn here.
  [[nodiscard]] Random child(std::string_view name) const noexcept;

  [[nodiscard]] std::uint64_t bits() noexcept;
  /// In [0, 1).
  [[nodiscard]] double uniform() noexcept;
  /// In [low, high).
  [[nodiscard]] double uniform(double low, double high) noexcept;
  /// In [0, count).
  [[nodiscard]] std::uint32_t below(std::uint32_t count) noexcept;
  /// Mean 0, standard deviation 1.
  [[nodiscard]] double normal() noexcept;
  /// Unit vector, every heading alike.
  [[nodiscard]] Vec2 heading() noexcept;

 private:
  std::uint64_t seed_;
  std::uint64_t state_[4];
};

}  // namespace galilean
