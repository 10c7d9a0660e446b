// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/command_line/description.h"

namespace galilean::front {

// The scripts that make a shell complete a command line. All that they offer stands in them, but
// for files: no program is started while somebody types.

[[nodiscard]] std::string bash_completion(const CommandDescription& tree);
[[nodiscard]] std::string zsh_completion(const CommandDescription& tree);
[[nodiscard]] std::string fish_completion(const CommandDescription& tree);

}  // namespace galilean::front
