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

}  // namespace galilean::monitor
