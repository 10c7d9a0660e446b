// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <thread>
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

/// Opens a pipe for writing, as soon as somebody reads it. To wait for that in open() would take no
/// signal where the program has blocked those that end it. Returns -1, with the reason in errno.
int open_pipe(const std::string& path) {
  constexpr auto kLongest = std::chrono::seconds(5);
  constexpr auto kLookEach = std::chrono::milliseconds(10);
  const auto end = std::chrono::steady_clock::now() + kLongest;
  for (;;) {
    const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor >= 0) fcntl(descriptor, F_SETFL, fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
    if (descriptor >= 0 || errno != ENXIO || std::chrono::steady_clock::now() >= end)
      return descriptor;
    std::this_thread::sleep_for(kLookEach);
  }
}

}  // namespace

Result<FileSink> FileSink::create(const std::string& path, bool replace) {
  std::error_code unknown;
  // A pipe or a device is there before, and nothing in it is lost.
  const bool may_be_there = replace || std::filesystem::is_other(path, unknown);
  const int how = O_WRONLY | O_CREAT | O_CLOEXEC | (may_be_there ? O_TRUNC : O_EXCL);
  const bool is_pipe = std::filesystem::is_fifo(path, unknown);
  const int descriptor = is_pipe ? open_pipe(path) : open(path.c_str(), how, 0644);
  if (descriptor >= 0) {
    // Tells readers that the file is being written. Where the disk knows no locks they are not
    // told.
    (void)flock(descriptor, LOCK_EX | LOCK_NB);
    return FileSink(path, descriptor);
  }
  if (errno == EEXIST)
    return Error{path + " exists already; choose another name, or give --replace"};
  if (is_pipe && errno == ENXIO)
    return Error{path + " is a pipe that nobody reads; start its reader first"};
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
