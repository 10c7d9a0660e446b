// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/result.h"

namespace galilean::mcap {

/// The destination of a recording: a file, or a faulty disk in a test.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  /// Appends all of `bytes`. After a failure, a part of them may have been written.
  virtual Result<void> write(std::span<const std::uint8_t> bytes) = 0;
};

/// A file on disk. It has no buffer of its own, so the bytes of a successful write stay in the file
/// even if this process is killed.
class FileSink final : public ByteSink {
 public:
  /// Makes the file. With `replace`, empties a file that exists. Waits up to five seconds for who
  /// reads a pipe.
  /// Errors: the file exists and `replace` is false, it cannot be written, or nobody reads the
  /// pipe.
  [[nodiscard]] static Result<FileSink> create(const std::string& path, bool replace);
  /// Appends to this process's standard output, be it a file, a pipe or a socket.
  /// Errors: it is closed.
  [[nodiscard]] static Result<FileSink> standard_output();
  FileSink(FileSink&& other) noexcept
      : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileSink& operator=(FileSink&&) = delete;
  ~FileSink() override;

  Result<void> write(std::span<const std::uint8_t> bytes) override;
  /// Waits until all that was written is on the disk, so that it survives a loss of power.
  Result<void> sync();

 private:
  FileSink(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::string path_;
  int descriptor_;
};

}  // namespace galilean::mcap
