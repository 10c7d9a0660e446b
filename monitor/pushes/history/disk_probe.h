// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

#include "core/result.h"

namespace galilean::monitor {

/// Finds out whether a disk can be written, before somebody relies on it: a disk that fails says so
/// only to who writes. The bytes of a small file are written again and again, so that it needs no
/// room. For use by one thread.
class DiskProbe {
 public:
  explicit DiskProbe(std::filesystem::path file) : file_(std::move(file)) {}
  ~DiskProbe() { close(); }
  DiskProbe(const DiskProbe&) = delete;
  DiskProbe& operator=(const DiskProbe&) = delete;

  /// Writes the file, and waits until the disk has it. Errors: the disk cannot be written.
  [[nodiscard]] Result<void> write();

 private:
  static constexpr int kNone = -1;
  [[nodiscard]] Result<void> open();
  void close() noexcept;

  std::filesystem::path file_;
  int descriptor_ = kNone;
  std::uint64_t count_ = 0;  ///< so that no two writes are the same
};

}  // namespace galilean::monitor
