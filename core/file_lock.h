// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <utility>

#include "core/result.h"

namespace galilean {

/// Holds a lock on a file for as long as it lives, so that two processes that edit what the file
/// stands for do not lose one another's edits. The system ends it with the process.
class FileLock {
 public:
  /// Waits until nobody else has the lock. Makes the file, for its owner alone, if it is missing.
  /// Errors: it cannot be opened. The sentence names the file.
  [[nodiscard]] static Result<FileLock> wait_for(const std::filesystem::path& file);
  ~FileLock();
  FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, kNone)) {}
  FileLock& operator=(FileLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

 private:
  static constexpr int kNone = -1;
  explicit FileLock(int descriptor) noexcept : descriptor_(descriptor) {}

  int descriptor_ = kNone;
};

}  // namespace galilean
