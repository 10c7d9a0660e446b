// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"

namespace galilean::monitor {

/// The secrets of the monitor itself, which its own machine's commands send. People get named
/// tokens (named_tokens.h). `viewer` lets a client watch the team; `operator_` lets it watch and
/// steer the team.
struct Tokens {
  std::string viewer;
  std::string operator_;
  bool are_new = false;  ///< at least one of them was made just now
};

/// Returns the folder "galilean" in the user's state folder, as the XDG base directory
/// specification defines that. A monitor keeps its tokens and its history of pushes there.
[[nodiscard]] std::filesystem::path default_data_folder();
/// Returns the path of the operator's token in a data folder.
[[nodiscard]] std::filesystem::path operator_token_file(const std::filesystem::path& data_folder);

/// Reads viewer.token and operator.token, and makes those that are missing, readable by their owner
/// only (mode 0600).
/// Errors: a file cannot be written or read, or holds no token. The sentence says why.
[[nodiscard]] Result<Tokens> open_tokens(const std::filesystem::path& data_folder);
/// Reads one token.
/// Errors: the file cannot be read, or holds fewer than 16 characters.
[[nodiscard]] Result<std::string> read_token(const std::filesystem::path& file);

}  // namespace galilean::monitor
