// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/check.h"

namespace galilean::monitor {

struct LibraryEntry {
  std::string name;  ///< path below the library's folder
  std::string hash;  ///< empty if it does not check
};

/// The programs that ship: a folder of BHDL files.
class ProgramLibrary {
 public:
  /// `catalog`: what its programs are checked against where no robot is asked.
  ProgramLibrary(std::filesystem::path folder, Catalog catalog)
      : folder_(std::move(folder)), catalog_(std::move(catalog)) {}

  /// In the order of their names. Files that other programs only include are left out.
  [[nodiscard]] std::vector<LibraryEntry> list() const;
  /// The main file first, its includes after; nothing if `name` is not in the library.
  [[nodiscard]] std::optional<std::vector<bhdl::SourceFile>> read(const std::string& name) const;
  /// Checks texts; includes that are not among them are taken from the library.
  [[nodiscard]] bhdl::CheckResult check(std::vector<bhdl::SourceFile> files,
                                        const Catalog& catalog) const;
  [[nodiscard]] const Catalog& catalog() const noexcept { return catalog_; }

 private:
  [[nodiscard]] std::vector<std::string> names() const;
  /// Paths below the library's folder.
  [[nodiscard]] std::vector<bhdl::SourceFile> files_of(const std::string& name) const;

  std::filesystem::path folder_;
  Catalog catalog_;
};

/// The programs as they ship.
[[nodiscard]] std::filesystem::path default_library_folder();

}  // namespace galilean::monitor
