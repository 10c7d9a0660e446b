// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace galilean {

/// Returns the name of the user who runs this process: $USER, else the account's name, else its
/// number. Pushes and commands are signed with it.
[[nodiscard]] std::string user_name();

}  // namespace galilean
