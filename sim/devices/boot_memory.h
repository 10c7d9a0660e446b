// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace galilean::sim {

/// The non-volatile memory in which a board counts its starts. With a file the count survives the
/// simulator, so that a robot that outlives it knows that its board began anew.
class BootMemory {
 public:
  /// Forgets with this object.
  BootMemory() = default;
  /// Goes on from what the file says. A file that is missing is made by `count_start`.
  explicit BootMemory(std::filesystem::path file);

  /// Returns the number of this start, from 1 to 65535 and then again from 1. It differs from that
  /// of the start before.
  std::uint16_t count_start();
  /// Returns one sentence on what could not be read or kept and what to do, or an empty text.
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

 private:
  void keep();

  std::filesystem::path file_;  ///< empty: none
  std::uint16_t count_ = 0;
  std::string problem_;
};

}  // namespace galilean::sim
