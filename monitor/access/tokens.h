// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"

namespace galilean::monitor {

/// What lets its bearer watch a team, or watch and steer it.
struct Tokens {
  std::string viewer;
  std::string operator_;
  bool are_new = false;  ///< nobody has them yet
};

/// The user's state folder, as the XDG base directory specification has it: where a monitor keeps
/// what must survive it.
[[nodiscard]] std::filesystem::path default_data_folder();
[[nodiscard]] std::filesystem::path operator_token_file(const std::filesystem::path& data_folder);

/// Reads viewer.token and operator.token; makes those that are missing, for the owner's eyes alone
/// (mode 0600). The error says what to do.
[[nodiscard]] Result<Tokens> open_tokens(const std::filesystem::path& data_folder);
/// One token; the error says what to do.
[[nodiscard]] Result<std::string> read_token(const std::filesystem::path& file);

}  // namespace galilean::monitor
