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
  /// Has the next write begin at `offset`, over what is there. Makes sure before that `bytes` fit
  /// from there. Errors: they do not, or what was written cannot be changed; nothing has changed.
  virtual Result<void> go_back(std::uint64_t offset, std::uint64_t bytes);
};

/// A file on disk. It has no buffer of its own, so the bytes of a successful write stay in the file
/// even if this process is killed.
class FileSink final : public ByteSink {
 public:
  /// Makes the file. With `replace`, empties a file that exists. Waits up to five seconds for who
  /// reads a pipe. While this lives no other FileSink writes the file.
  /// Errors: the file exists and `replace` is false, it cannot be written, another FileSink writes
  /// it, or nobody reads the pipe.
  [[nodiscard]] static Result<FileSink> create(const std::string& path, bool replace);
  /// Appends to this process's standard output, be it a file, a pipe or a socket.
  /// Errors: it is closed.
  [[nodiscard]] static Result<FileSink> standard_output();
  FileSink(FileSink&& other) noexcept;
  FileSink& operator=(FileSink&&) = delete;
  /// Removes a file that this made if nothing could be written to it.
  ~FileSink() override;

  Result<void> write(std::span<const std::uint8_t> bytes) override;
  Result<void> go_back(std::uint64_t offset, std::uint64_t bytes) override;
  /// Waits until all that was written is on the disk, so that it survives a loss of power.
  /// Errors: it cannot be written, and those of check_whole.
  Result<void> sync();
  /// Errors: the file was deleted, or another program has shortened it.
  [[nodiscard]] Result<void> check_whole() const;
  /// Returns whether the file stands under another name than that with which it was made.
  [[nodiscard]] bool has_moved() const;

 private:
  FileSink(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}
  [[nodiscard]] Result<void> write_all(std::span<const std::uint8_t> bytes);

  std::string path_;
  int descriptor_;
  bool is_file_ = false;                    ///< a regular one, which has a path
  bool made_ = false;                       ///< it was not there before
  bool failed_ = false, cut_ = false;       ///< a write failed; another program has shortened it
  std::uint64_t position_ = 0, bytes_ = 0;  ///< of the next write, and of all that was written
};

}  // namespace galilean::mcap
