// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "monitor/access/named_tokens.h"

namespace galilean::monitor {

/// Notices that the file of the named tokens has changed. A look costs one system call while it has
/// not, so that no inotify is needed, which some file systems do not have.
class TokenWatch {
 public:
  explicit TokenWatch(std::filesystem::path file) : file_(std::move(file)) {}

  /// Returns what the file holds, at the first look and whenever it has changed since the last one;
  /// otherwise nothing. Errors, inside: those of read_named_tokens.
  [[nodiscard]] std::optional<Result<std::vector<NamedToken>>> look();

 private:
  /// All zeros where the file is not there. The file is replaced and never written into, so that
  /// its number differs also where two changes fall into one tick of the file system's clock.
  struct Mark {
    ino_t number = 0;
    off_t bytes = 0;
    mode_t mode = 0;
    std::int64_t written_s = 0;  ///< since 1970, with the nanoseconds of that second
    std::int64_t written_ns = 0;
    bool operator==(const Mark&) const = default;
  };
  [[nodiscard]] Mark mark() const;

  std::filesystem::path file_;
  std::optional<Mark> last_;
};

}  // namespace galilean::monitor
