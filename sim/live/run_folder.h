// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"

namespace galilean::sim {

/// A folder for one run's serial lines: $XDG_RUNTIME_DIR/galilean-<run>, or below /tmp. Only one
/// simulator can own the folder of a run. The folder and its content are removed with this object.
class RunFolder {
 public:
  [[nodiscard]] static Result<RunFolder> make(const std::string& run);
  ~RunFolder();
  RunFolder(RunFolder&& other) noexcept;
  RunFolder& operator=(RunFolder&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  RunFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

  std::filesystem::path path_;
  int lock_;
};

}  // namespace galilean::sim
