// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/result.h"

namespace galilean::mcap {

/// Why something was not done; empty: it was.
using Failure = std::optional<Error>;

/// Where a recording goes: a file, or a test's faulty disk.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  /// Appends all of `bytes`. After a failure part of them may have been written.
  [[nodiscard]] virtual Failure write(std::span<const std::uint8_t> bytes) = 0;
};

/// A file on disk. Unbuffered: what was written survives the end of this process, however it ends.
class FileSink final : public ByteSink {
 public:
  /// Makes the file, or fails if there is one already and `replace` is not given.
  [[nodiscard]] static Result<FileSink> create(const std::string& path, bool replace);
  FileSink(FileSink&& other) noexcept
      : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileSink& operator=(FileSink&&) = delete;
  ~FileSink() override;

  [[nodiscard]] Failure write(std::span<const std::uint8_t> bytes) override;
  /// Waits until the disk has it all.
  [[nodiscard]] Failure sync();

 private:
  FileSink(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::string path_;
  int descriptor_;
};

}  // namespace galilean::mcap
