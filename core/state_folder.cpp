// SPDX-License-Identifier: BSD-3-Clause
#include "core/state_folder.h"

#include <cstdlib>

namespace galilean {

std::filesystem::path state_folder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state)
    return std::filesystem::path(state) / "galilean";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home && *home ? home : ".") / ".local" / "state" / "galilean";
}

}  // namespace galilean
