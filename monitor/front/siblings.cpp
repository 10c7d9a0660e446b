// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/siblings.h"

#include <unistd.h>

#include "core/installation.h"

namespace galilean::front {

std::string sibling(std::string_view program) {
  return (program_folder() / program).string();
}

bool is_program(const std::string& path) {
  return access(path.c_str(), X_OK) == 0;
}

}  // namespace galilean::front
