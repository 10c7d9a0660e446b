// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

#include "core/result.h"

namespace galilean::monitor {

/// A file that takes room on the disk and that nobody reads. It is given up when the disk is full,
/// so that what must be written still can be. For use by one thread.
class DiskReserve {
 public:
  /// `bytes` 0: there is no reserve.
  DiskReserve(std::filesystem::path file, std::uintmax_t bytes)
      : file_(std::move(file)), bytes_(bytes) {}

  /// Takes the room if it is not taken, also over the room that a former process took. Errors: the
  /// disk has not so much room, or the file cannot be written; nothing of it is left then.
  [[nodiscard]] Result<void> take();
  /// Gives the room up. Returns whether there was any.
  bool release();
  [[nodiscard]] bool is_taken() const noexcept { return is_taken_; }
  [[nodiscard]] std::uintmax_t bytes() const noexcept { return bytes_; }

 private:
  std::filesystem::path file_;
  std::uintmax_t bytes_;
  bool is_taken_ = false;
};

}  // namespace galilean::monitor
