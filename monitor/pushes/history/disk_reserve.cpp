// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/disk_reserve.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace galilean::monitor {

Result<void> DiskReserve::take() {
  if (is_taken_ || bytes_ == 0) return {};
  const int file = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0)
    return Error{"the reserve " + file_.string() + " cannot be made: " + std::strerror(errno)};
  const int failed = posix_fallocate(file, 0, static_cast<off_t>(bytes_));
  ::close(file);
  if (failed == 0) {
    is_taken_ = true;
    return {};
  }
  std::error_code none;
  std::filesystem::remove(file_, none);
  return Error{"the reserve " + file_.string() + " cannot be made: " + std::strerror(failed)};
}

bool DiskReserve::release() {
  if (!is_taken_) return false;
  is_taken_ = false;
  std::error_code failed;
  return std::filesystem::remove(file_, failed);
}

}  // namespace galilean::monitor
