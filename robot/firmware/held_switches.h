// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace galilean::robot::firmware {

/// Debounces switches. A switch counts as on at once. It counts as off only after it was off for
/// the hold time without a break. A push that is shorter than the time between two Status messages
/// is therefore seen.
class HeldSwitches {
 public:
  static constexpr std::size_t kSwitches = 9;
  static constexpr std::uint32_t kHold_ms = 25;

  /// Takes bit n as switch n, and returns the bits that count as on.
  std::uint16_t step(std::uint16_t bits, std::uint32_t now_ms) {
    for (std::size_t i = 0; i < kSwitches; ++i) {
      const auto mask = static_cast<std::uint16_t>(1u << i);
      if (bits & mask) {
        held_ |= mask;
        last_on_ms_[i] = now_ms;
      } else if (now_ms - last_on_ms_[i] >= kHold_ms) {
        held_ &= static_cast<std::uint16_t>(~mask);
      }
    }
    return held_;
  }

 private:
  std::uint16_t held_ = 0;
  std::array<std::uint32_t, kSwitches> last_on_ms_{};
};

}  // namespace galilean::robot::firmware
