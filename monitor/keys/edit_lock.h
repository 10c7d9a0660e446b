// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace galilean::monitor {

/// Holds a lock on a team's folder for as long as it lives, so that two edits do not lose one
/// another's.
class EditLock {
 public:
  explicit EditLock(const std::filesystem::path& team_folder);
  ~EditLock();
  EditLock(const EditLock&) = delete;
  EditLock& operator=(const EditLock&) = delete;
  /// Returns why there is no lock, such as that the folder is not there; empty if there is one.
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

 private:
  int descriptor_ = -1;
  std::string problem_;
};

}  // namespace galilean::monitor
