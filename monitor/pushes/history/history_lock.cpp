// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/history_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "core/private_file.h"

namespace galilean::monitor {

Result<HistoryLock> HistoryLock::take(const std::filesystem::path& file) {
  const auto opened = open_private_file(file, O_RDWR);
  if (!opened) return HistoryLock();
  HistoryLock lock(opened.value());
  // Some file systems know no locks. A history on one of them is used as it is.
  if (flock(opened.value(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return lock;
  return Error{"another monitor has locked " + file.string()};
}

HistoryLock::~HistoryLock() {
  if (descriptor_ != kNone) close(descriptor_);
}

std::filesystem::path lock_file_of(const std::filesystem::path& history) {
  return history.string() + ".lock";
}

}  // namespace galilean::monitor
