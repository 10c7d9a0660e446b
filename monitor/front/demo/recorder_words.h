// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace galilean::front {

/// Follows what `galilean record` says in its log of what is not as it should be.
class RecorderWords {
 public:
  explicit RecorderWords(std::filesystem::path log) : log_(std::move(log)) {}

  /// Returns the sentences that have come since the last call, without the program's name.
  [[nodiscard]] std::vector<std::string> take();

 private:
  std::filesystem::path log_;
  std::streamoff read_ = 0;  ///< bytes
};

/// Returns whether a sentence of `galilean record` says that the disk is nearly full.
[[nodiscard]] bool tells_of_full_disk(const std::string& sentence);

}  // namespace galilean::front
