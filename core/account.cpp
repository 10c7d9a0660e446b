// SPDX-License-Identifier: BSD-3-Clause
#include "core/account.h"

#include <pwd.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

namespace galilean {

std::string user_name() {
  if (const char* name = std::getenv("USER"); name && *name) return name;
  passwd entry{};
  passwd* found = nullptr;
  std::array<char, 4096> room{};
  if (getpwuid_r(getuid(), &entry, room.data(), room.size(), &found) == 0 && found)
    return found->pw_name;
  return "user " + std::to_string(getuid());
}

}  // namespace galilean
