// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

namespace galilean::monitor {

/// Returns the folder in which a monitor keeps its history of pushes if it was told none. Monitors
/// that share a user's data folder, such as those of several demos, each have one of their own, by
/// their DDS domain and their port. The monitor of domain 0 on port 8080 has the data folder
/// itself, where all of them used to keep it.
[[nodiscard]] std::filesystem::path history_folder(const std::filesystem::path& data_folder,
                                                   std::uint32_t domain, std::uint16_t port);
/// Returns the file in which such a monitor keeps its history from now on. Monitors that take any
/// free port have a folder in common: one that another uses now is not taken, but the next one,
/// with a number at its end.
[[nodiscard]] std::filesystem::path history_file(const std::filesystem::path& data_folder,
                                                 std::uint32_t domain, std::uint16_t port);

/// The history's file in its folder.
inline constexpr const char* kHistoryFile = "history.sqlite";

}  // namespace galilean::monitor
