// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace galilean::monitor {

/// Returns how many bytes a user may still write beside `path`. Nothing: the system does not say,
/// or `path` is a pipe or a device.
[[nodiscard]] std::optional<std::uint64_t> free_bytes(const std::string& path);

/// Decides whether there is room to record. It takes more room to begin again than to go on, so
/// that a disk at its limit does not begin a file each second.
class DiskRoom {
 public:
  using Ask = std::function<std::optional<std::uint64_t>()>;

  /// `least_bytes` is what must stay free; 0: there is always room.
  DiskRoom(std::uint64_t least_bytes, Ask ask) : least_bytes_(least_bytes), ask_(std::move(ask)) {}

  /// Asks the disk. Returns whether there is room.
  bool look();
  /// Returns what the last look saw, in bytes.
  [[nodiscard]] std::uint64_t free() const noexcept { return free_; }
  [[nodiscard]] std::uint64_t least() const noexcept { return least_bytes_; }

 private:
  std::uint64_t least_bytes_;
  Ask ask_;
  bool has_room_ = true;
  std::uint64_t free_ = 0;
};

}  // namespace galilean::monitor
