// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::mcap {

/// The bytes of a recording, for reading.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Returns the present size in bytes; 0 if it cannot be read.
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// Fills `to` with the bytes from `offset` on. Returns false if there are not that many bytes, or
  /// the disk fails.
  [[nodiscard]] virtual bool read(std::uint64_t offset, std::span<std::uint8_t> to) const = 0;
  /// Returns whether a recorder of Galilean is writing to it now.
  [[nodiscard]] virtual bool is_being_written() const { return false; }
};

/// A file on disk. It may shrink or grow while it is read.
class FileSource final : public ByteSource {
 public:
  /// Errors: the file cannot be opened, or is no regular file, but a pipe or a device.
  [[nodiscard]] static Result<FileSource> open(const std::string& path);
  /// Takes an open file's descriptor over.
  [[nodiscard]] static FileSource of(int descriptor) { return FileSource(descriptor); }
  FileSource(FileSource&& other) noexcept;
  FileSource& operator=(FileSource&&) = delete;
  ~FileSource() override;

  [[nodiscard]] std::uint64_t size() const override;
  [[nodiscard]] bool read(std::uint64_t offset, std::span<std::uint8_t> to) const override;
  [[nodiscard]] bool is_being_written() const override;

 private:
  explicit FileSource(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

/// Bytes in memory, which must outlive it.
class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] bool read(std::uint64_t offset, std::span<std::uint8_t> to) const override;

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace galilean::mcap
