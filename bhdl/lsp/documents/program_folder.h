// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/source/source_provider.h"

namespace galilean::bhdl::lsp {

/// Reads the files that no editor has open, from the disk or from a library of programs. Paths are
/// absolute.
class ProgramFolder : public SourceProvider {
 public:
  /// Returns the BHDL files in the folder of `path`, in the order of their names, at most
  /// kMostBeside.
  [[nodiscard]] virtual std::vector<std::string> beside(const std::string& path) const = 0;
  [[nodiscard]] std::string shown(const std::string& path) const override { return path; }

  static constexpr std::size_t kMostBeside = 64;
};

/// The disk below `root`; "/" for all of it.
class DiskFolder : public ProgramFolder {
 public:
  explicit DiskFolder(std::filesystem::path root = "/") : root_(std::move(root)) {}
  [[nodiscard]] Result<std::string, ReadFailure> read(const std::string& path,
                                                      std::size_t most_bytes) const override;
  [[nodiscard]] std::vector<std::string> beside(const std::string& path) const override;

 private:
  [[nodiscard]] std::filesystem::path place_of(const std::string& path) const;

  std::filesystem::path root_;
};

}  // namespace galilean::bhdl::lsp
