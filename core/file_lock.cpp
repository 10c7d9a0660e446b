// SPDX-License-Identifier: BSD-3-Clause
#include "core/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "core/private_file.h"

namespace galilean {

Result<FileLock> FileLock::wait_for(const std::filesystem::path& file) {
  const auto opened = open_private_file(file, O_RDWR);
  if (!opened) return opened.error();
  FileLock lock(opened.value());
  // Some file systems know no locks. A file on one of them is edited all the same.
  while (flock(opened.value(), LOCK_EX) != 0 && errno == EINTR) {
  }
  return lock;
}

FileLock::~FileLock() {
  if (descriptor_ != kNone) close(descriptor_);
}

}  // namespace galilean
