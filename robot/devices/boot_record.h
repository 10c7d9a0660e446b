// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace galilean::robot {

/// Notices when a board was reset, or is another one. After a reset its boot count differs, or its
/// uptime is less than before. Another board has another name, or looks like one that was reset.
class BootRecord {
 public:
  using Name = std::array<std::uint8_t, 16>;

  /// The uptime begins anew after 49.7 days, as it does after a reset. It is taken for the same run
  /// of the board if it went on by less than this.
  static constexpr std::uint32_t kLongestSilence_ms = 3'600'000;

  [[nodiscard]] bool differs(std::uint16_t boot_count, std::uint32_t uptime_ms) const {
    const bool went_back = uptime_ms < uptime_ms_ && uptime_ms - uptime_ms_ >= kLongestSilence_ms;
    return boot_count != boot_count_ || went_back;
  }
  void note(std::uint16_t boot_count, std::uint32_t uptime_ms) {
    if (known_ && differs(boot_count, uptime_ms)) ++epoch_;
    known_ = true;
    boot_count_ = boot_count;
    uptime_ms_ = uptime_ms;
  }
  /// Notes what a board says of itself when a session begins.
  void note_greeting(const Name& name, std::uint16_t boot_count, std::uint32_t uptime_ms) {
    const bool is_another = known_ && name != name_ && !differs(boot_count, uptime_ms);
    name_ = name;
    note(boot_count, uptime_ms);
    if (is_another) ++epoch_;
  }
  /// Returns how many resets and exchanges were noticed.
  [[nodiscard]] std::uint32_t epoch() const { return epoch_; }

 private:
  bool known_ = false;
  Name name_{};
  std::uint16_t boot_count_ = 0;
  std::uint32_t uptime_ms_ = 0;
  std::uint32_t epoch_ = 0;
};

}  // namespace galilean::robot
