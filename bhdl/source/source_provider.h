// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

#include "bhdl/source/source_file.h"
#include "core/result.h"

namespace galilean::bhdl {

/// Why a file could not be read: a diagnostic's code and message without its place.
struct ReadFailure {
  std::string code;
  std::string message;
};

/// Returns the failure of a file that has more bytes than may be read.
[[nodiscard]] ReadFailure too_large(const std::string& path, std::uintmax_t bytes,
                                    std::size_t most_bytes);

/// The source of a program's texts: the disk, or a push over the network.
class SourceProvider {
 public:
  virtual ~SourceProvider() = default;
  /// Returns the text of a file. `path` is relative to the main file's folder, without `.` and
  /// needless `..`. Errors: there is no such file, or it has more than `most_bytes` bytes.
  [[nodiscard]] virtual Result<std::string, ReadFailure> read(const std::string& path,
                                                              std::size_t most_bytes) const = 0;
  /// Returns the name that diagnostics use for the file.
  [[nodiscard]] virtual std::string shown(const std::string& path) const = 0;
};

/// Reads regular files below or beside a folder.
class DiskSources : public SourceProvider {
 public:
  explicit DiskSources(std::filesystem::path folder) : folder_(std::move(folder)) {}
  [[nodiscard]] Result<std::string, ReadFailure> read(const std::string& path,
                                                      std::size_t most_bytes) const override;
  [[nodiscard]] std::string shown(const std::string& path) const override;

 private:
  std::filesystem::path folder_;
};

/// Provides texts that are already in memory. No other file can be read.
class MemorySources : public SourceProvider {
 public:
  /// Requires: `files` outlives this object. Of two files with one path, the first counts.
  explicit MemorySources(const std::vector<SourceFile>& files);
  [[nodiscard]] Result<std::string, ReadFailure> read(const std::string& path,
                                                      std::size_t most_bytes) const override;
  [[nodiscard]] std::string shown(const std::string& path) const override { return path; }

 private:
  std::unordered_map<std::string, const SourceFile*> files_;
};

/// Returns `path` without `.`, and without every `..` that can be resolved.
[[nodiscard]] std::string normal_path(const std::filesystem::path& path);

}  // namespace galilean::bhdl
