// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace galilean::robot {

/// Notices when a board was reset. After a reset its boot count differs, or its uptime is less than
/// before.
class BootRecord {
 public:
  [[nodiscard]] bool differs(std::uint16_t boot_count, std::uint32_t uptime_ms) const {
    return boot_count != boot_count_ || uptime_ms < uptime_ms_;
  }
  void note(std::uint16_t boot_count, std::uint32_t uptime_ms) {
    if (known_ && differs(boot_count, uptime_ms)) ++epoch_;
    known_ = true;
    boot_count_ = boot_count;
    uptime_ms_ = uptime_ms;
  }
  /// Returns how many resets were noticed.
  [[nodiscard]] std::uint32_t epoch() const { return epoch_; }

 private:
  bool known_ = false;
  std::uint16_t boot_count_ = 0;
  std::uint32_t uptime_ms_ = 0;
  std::uint32_t epoch_ = 0;
};

}  // namespace galilean::robot
