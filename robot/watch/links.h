// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace galilean::robot {

/// The way that the system goes from a path to a file.
struct FollowedPath {
  std::vector<std::filesystem::path> links;  ///< the links on the way, in their order
  std::filesystem::path file;                ///< where the way ends; contains no link
};

/// Follows all links of a path, those to folders, too. The file and its folders need not exist. A
/// link that leads back to itself is followed a limited number of times.
[[nodiscard]] FollowedPath follow_links(const std::filesystem::path& path);

}  // namespace galilean::robot
