// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/source/source_file.h"
#include "core/result.h"

namespace galilean::robot {

/// What keeps a robot still that operators asked for. No death of the robot program ends it.
struct KeptOrders {
  static constexpr std::size_t kMostHolderBytes = 64;

  std::string held_by;  ///< who or what holds the robot, but for faults; empty: nobody
  bool out_of_service = false;

  bool operator==(const KeptOrders&) const = default;
};

/// What a robot program keeps on disk for its next start.
struct KeptProgram {
  std::string robot;     ///< its name
  bool running = false;  ///< the robot program has not ended in order
  bool pushed = false;   ///< a push brought the program, and not --bhdl or a file that was saved
  std::string hash;      ///< of the last program that proved itself
  std::vector<bhdl::SourceFile> files;  ///< of that program, the main file first
  KeptOrders orders = {};
};

/// Returns the file in which the robot of this name in this DDS domain keeps it.
[[nodiscard]] std::filesystem::path kept_program_file(const std::filesystem::path& state_folder,
                                                      const std::string& robot,
                                                      std::uint32_t domain);

/// Returns nothing if there is no such file. Errors: it cannot be read, it is cut short, or it is
/// not what this robot wrote. The message is one sentence that names the file.
[[nodiscard]] Result<std::optional<KeptProgram>> read_kept_program(
    const std::filesystem::path& file, const std::string& robot);

/// Puts the file in place whole or not at all, and makes its folder. It waits for the disk. Errors:
/// that failed, and what was kept before is still there. The message is one sentence that names the
/// file.
[[nodiscard]] Result<void> write_kept_program(const std::filesystem::path& file,
                                              const KeptProgram& kept);

}  // namespace galilean::robot
