// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <utility>

#include "core/result.h"

namespace galilean::monitor {

/// Says to other monitors that a history is in use. The system ends it with the process, also with
/// one that is killed.
class HistoryLock {
 public:
  /// Makes the file if it is missing. Where no file can be made or locked, nothing is locked.
  /// Errors: another process has the lock, or this one has it already.
  [[nodiscard]] static Result<HistoryLock> take(const std::filesystem::path& file);
  HistoryLock() = default;
  ~HistoryLock();
  HistoryLock(HistoryLock&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, kNone)) {}
  HistoryLock& operator=(HistoryLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

 private:
  static constexpr int kNone = -1;
  explicit HistoryLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_ = kNone;
};

/// Returns the file by which the history in `history` is locked.
[[nodiscard]] std::filesystem::path lock_file_of(const std::filesystem::path& history);

}  // namespace galilean::monitor
