// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::mcap {

/// What a recording is read from.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// Fills `to` from `offset` on; false if there are not so many bytes, or the disk fails.
  [[nodiscard]] virtual bool read(std::uint64_t offset, std::span<std::uint8_t> to) const = 0;
};

/// A file on disk. May be cut or grow while it is read.
class FileSource final : public ByteSource {
 public:
  [[nodiscard]] static Result<FileSource> open(const std::string& path);
  FileSource(FileSource&& other) noexcept;
  FileSource& operator=(FileSource&&) = delete;
  ~FileSource() override;

  [[nodiscard]] std::uint64_t size() const override;
  [[nodiscard]] bool read(std::uint64_t offset, std::span<std::uint8_t> to) const override;

 private:
  explicit FileSource(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

/// Bytes in memory.
class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] bool read(std::uint64_t offset, std::span<std::uint8_t> to) const override;

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace galilean::mcap
