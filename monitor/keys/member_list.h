// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "monitor/keys/team_keys.h"

namespace galilean::monitor {

/// Returns a team's list of certificates as the file members.json holds it.
[[nodiscard]] std::string member_list_text(const std::vector<TeamMember>& members);

/// Reads that file. Errors: it is not there, cannot be read, or is damaged. The sentence names it.
[[nodiscard]] Result<std::vector<TeamMember>> read_member_list(const std::filesystem::path& file);

/// Reads a file of keys whole. Errors: it cannot be read. The sentence names it.
[[nodiscard]] Result<std::string> read_member_file(const std::filesystem::path& file);

}  // namespace galilean::monitor
