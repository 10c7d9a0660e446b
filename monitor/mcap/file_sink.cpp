// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "monitor/mcap/byte_sink.h"

namespace galilean::mcap {

Result<FileSink> FileSink::create(const std::string& path, bool replace) {
  const int how = O_WRONLY | O_CREAT | O_CLOEXEC | (replace ? O_TRUNC : O_EXCL);
  const int descriptor = open(path.c_str(), how, 0644);
  if (descriptor >= 0) {
    // Tells readers that the file is being written. Where the disk knows no locks they are not
    // told.
    (void)flock(descriptor, LOCK_EX | LOCK_NB);
    return FileSink(path, descriptor);
  }
  if (errno == EEXIST)
    return Error{path + " exists already; choose another name, or give --replace"};
  return Error{path + " cannot be written: " + std::strerror(errno)};
}

FileSink::~FileSink() {
  if (descriptor_ >= 0) close(descriptor_);
}

Result<void> FileSink::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return Error{path_ + " cannot be written: " + std::strerror(errno)};
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return {};
}

Result<void> FileSink::sync() {
  // EINVAL and EROFS mean a pipe or a device, which cannot be synchronized.
  if (fsync(descriptor_) == 0 || errno == EINVAL || errno == EROFS) return {};
  return Error{path_ + " cannot be written: " + std::strerror(errno)};
}

}  // namespace galilean::mcap
