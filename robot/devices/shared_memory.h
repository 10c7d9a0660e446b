// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/result.h"

namespace galilean::robot {

/// A named piece of memory that processes share. It is mapped as long as this object lives.
class SharedMemory {
 public:
  /// Opens memory for writing, and locks it against other writers until the process ends. It is
  /// made if it is missing or has another size. Errors: another process owns it, or the system
  /// refuses it.
  [[nodiscard]] static Result<SharedMemory> own(const std::string& name, std::size_t bytes);
  /// Opens memory that another process owns. Errors: it is missing or has another size.
  [[nodiscard]] static Result<SharedMemory> join(const std::string& name, std::size_t bytes);
  ~SharedMemory();
  SharedMemory(SharedMemory&& other) noexcept;
  SharedMemory& operator=(SharedMemory&& other) noexcept;

  [[nodiscard]] std::span<std::byte> bytes() const { return bytes_; }
  /// Returns whether the name still stands for this memory. It does not if the memory was removed
  /// or replaced by a newer one.
  [[nodiscard]] bool is_current(const std::string& name) const;
  static void remove(const std::string& name);

 private:
  SharedMemory(int file, std::span<std::byte> bytes) : file_(file), bytes_(bytes) {}
  void release();

  int file_ = -1;
  std::span<std::byte> bytes_;
};

}  // namespace galilean::robot
