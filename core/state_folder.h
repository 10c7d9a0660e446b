// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace galilean {

/// Returns the folder in which programs keep what they need when they are started again: galilean
/// in $XDG_STATE_HOME, or in ~/.local/state without that variable. It need not be there yet.
[[nodiscard]] std::filesystem::path state_folder();

}  // namespace galilean
