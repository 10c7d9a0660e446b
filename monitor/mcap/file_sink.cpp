// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "monitor/mcap/byte_sink.h"

namespace galilean::mcap {
namespace {

Error not_written(const std::string& path, int reason) {
  std::string sentence = path + " cannot be written: " + std::strerror(reason);
  if (reason == EFBIG) sentence += ", by the limit that 'ulimit -f' shows";
  return Error{std::move(sentence)};
}

/// Waits until a descriptor that does not wait by itself takes bytes again, or has failed.
void wait_for_room(int descriptor) {
  pollfd event{descriptor, POLLOUT, 0};
  poll(&event, 1, -1);
}

}  // namespace

Result<FileSink> FileSink::create(const std::string& path, bool replace) {
  std::error_code unknown;
  // A pipe or a device is there before, and nothing in it is lost.
  const bool may_be_there = replace || std::filesystem::is_other(path, unknown);
  const int how = O_WRONLY | O_CREAT | O_CLOEXEC | (may_be_there ? O_TRUNC : O_EXCL);
  const int descriptor = open(path.c_str(), how, 0644);
  if (descriptor >= 0) {
    // Tells readers that the file is being written. Where the disk knows no locks they are not
    // told.
    (void)flock(descriptor, LOCK_EX | LOCK_NB);
    return FileSink(path, descriptor);
  }
  if (errno == EEXIST)
    return Error{path + " exists already; choose another name, or give --replace"};
  return not_written(path, errno);
}

Result<FileSink> FileSink::standard_output() {
  constexpr int kBehindTheStandardOnes = 3;
  const int descriptor = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, kBehindTheStandardOnes);
  if (descriptor < 0) return not_written("standard output", errno);
  return FileSink("standard output", descriptor);
}

FileSink::~FileSink() {
  if (descriptor_ >= 0) close(descriptor_);
}

Result<void> FileSink::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) {
      wait_for_room(descriptor_);
      continue;
    }
    if (count < 0) return not_written(path_, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return {};
}

Result<void> FileSink::sync() {
  // EINVAL and EROFS mean a pipe or a device, which cannot be synchronized.
  if (fsync(descriptor_) == 0 || errno == EINVAL || errno == EROFS) return {};
  return not_written(path_, errno);
}

}  // namespace galilean::mcap
