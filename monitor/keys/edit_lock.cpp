// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/keys/edit_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/private_file.h"

namespace galilean::monitor {

EditLock::EditLock(const std::filesystem::path& team_folder) {
  std::error_code unknown;
  if (!std::filesystem::is_directory(team_folder, unknown)) {
    problem_ = team_folder.string() +
               " is no folder of a team; make one with 'galilean team keys init', or name it with "
               "--team";
    return;
  }
  const auto opened = open_private_file(team_folder / "members.lock", O_RDWR);
  if (!opened) {
    problem_ = opened.error().message;
    return;
  }
  descriptor_ = opened.value();
  while (flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
  }
}

EditLock::~EditLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

}  // namespace galilean::monitor
