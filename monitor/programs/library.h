// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/check.h"

namespace galilean::monitor {

struct LibraryEntry {
  std::string name;  ///< path below the library's folder
  std::string hash;  ///< the program's hash; empty if the program has errors
};

/// A file of the library that takes the place of an include that was not sent.
struct TakenFile {
  std::string path;  ///< as the program names it
  std::string from;  ///< the file on this machine
};
void to_json(nlohmann::json& json, const TakenFile& file);
/// Returns one sentence without its stop; an empty text if nothing was taken.
[[nodiscard]] std::string in_words(const std::vector<TakenFile>& taken);

/// The installed programs: a folder of BHDL files, which is read anew at every call. Any thread may
/// use it.
class ProgramLibrary {
 public:
  /// `catalog` checks the library's own programs, and other programs while no robot has published a
  /// catalog.
  ProgramLibrary(std::filesystem::path folder, Catalog catalog)
      : folder_(std::move(folder)), catalog_(std::move(catalog)) {}

  /// Returns the programs in the order of their names. Leaves out a file that has errors if another
  /// program includes it, because such a file is no program by itself.
  [[nodiscard]] std::vector<LibraryEntry> list() const;
  /// Returns the program's main file and then its includes, or nothing if `name` is not in the
  /// library.
  [[nodiscard]] std::optional<std::vector<bhdl::SourceFile>> read(const std::string& name) const;
  /// Checks a program whose main file is the first of `files`. Includes that are not among `files`
  /// are read from the library.
  [[nodiscard]] bhdl::CheckResult check(std::vector<bhdl::SourceFile> files,
                                        const Catalog& catalog) const;
  /// Returns what such a check has read from the library, beside `sent`.
  [[nodiscard]] std::vector<TakenFile> taken(const std::vector<bhdl::SourceFile>& sent,
                                             const bhdl::CheckResult& checked) const;
  [[nodiscard]] const Catalog& catalog() const noexcept { return catalog_; }

 private:
  [[nodiscard]] std::vector<std::string> names() const;
  /// Returns a program's files with paths below the library's folder.
  [[nodiscard]] std::vector<bhdl::SourceFile> files_of(const std::string& name) const;

  std::filesystem::path folder_;
  Catalog catalog_;
};

/// Returns the folder of the installed programs.
[[nodiscard]] std::filesystem::path default_library_folder();

}  // namespace galilean::monitor
