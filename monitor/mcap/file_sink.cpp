// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "monitor/mcap/byte_sink.h"
#include "monitor/mcap/output_file.h"

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

using Status = struct stat;

bool is_regular(int descriptor) {
  Status status{};
  return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

/// Returns whether the path leads to the file that is open.
bool leads_to(const std::string& path, int descriptor) {
  Status open_file{}, found{};
  return fstat(descriptor, &open_file) == 0 && stat(path.c_str(), &found) == 0 &&
         open_file.st_dev == found.st_dev && open_file.st_ino == found.st_ino;
}

}  // namespace

Result<void> ByteSink::go_back(std::uint64_t, std::uint64_t) {
  return Error{"what was written cannot be changed"};
}

Result<FileSink> FileSink::create(const std::string& path, bool replace) {
  std::error_code unknown;
  // A pipe or a device is there before, and nothing in it is lost.
  const bool may_be_there = replace || std::filesystem::is_other(path, unknown);
  const bool is_pipe = std::filesystem::is_fifo(path, unknown);
  bool made = false;
  const int descriptor =
      is_pipe ? open_output_pipe(path) : open_output_file(path, may_be_there, made);
  if (descriptor < 0 && errno == EEXIST)
    return Error{path + " exists already; choose another name, or give --replace"};
  if (descriptor < 0 && is_pipe && errno == ENXIO)
    return Error{path + " is a pipe that nobody reads; start its reader first"};
  if (descriptor < 0) return not_written(path, errno);
  FileSink sink(path, descriptor);
  sink.is_file_ = is_regular(descriptor);
  if (!sink.is_file_) return sink;
  if (!lock_output(descriptor))
    return Error{path + " is being written by another program; choose another name"};
  // Only now, because what another program writes is not to be emptied.
  if (!made && ftruncate(descriptor, 0) != 0) return not_written(path, errno);
  sink.made_ = made;
  return sink;
}

Result<FileSink> FileSink::standard_output() {
  constexpr int kBehindTheStandardOnes = 3;
  const int descriptor = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, kBehindTheStandardOnes);
  if (descriptor < 0) return not_written("standard output", errno);
  return FileSink("standard output", descriptor);
}

FileSink::FileSink(FileSink&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      is_file_(other.is_file_),
      made_(other.made_),
      failed_(other.failed_),
      cut_(other.cut_),
      position_(other.position_),
      bytes_(other.bytes_) {}

FileSink::~FileSink() {
  if (descriptor_ < 0) return;
  if (made_ && failed_ && bytes_ == 0 && leads_to(path_, descriptor_)) unlink(path_.c_str());
  close(descriptor_);
}

Result<void> FileSink::write(std::span<const std::uint8_t> bytes) {
  // Behind a write the file would look long enough, with a hole in it.
  cut_ = cut_ || !check_whole();
  auto done = write_all(bytes);
  failed_ = failed_ || !done;
  if (!done) return done;
  position_ += bytes.size();
  bytes_ = std::max(bytes_, position_);
  return {};
}

Result<void> FileSink::write_all(std::span<const std::uint8_t> bytes) {
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

Result<void> FileSink::go_back(std::uint64_t offset, std::uint64_t bytes) {
  if (!is_file_) return ByteSink::go_back(offset, bytes);
  // A disk that cannot set room aside is taken to have it.
  const auto from = static_cast<off_t>(offset);
  if (fallocate(descriptor_, FALLOC_FL_KEEP_SIZE, from, static_cast<off_t>(bytes)) != 0 &&
      (errno == ENOSPC || errno == EDQUOT || errno == EFBIG))
    return not_written(path_, errno);
  if (lseek(descriptor_, from, SEEK_SET) != from) return not_written(path_, errno);
  position_ = offset;
  return {};
}

Result<void> FileSink::check_whole() const {
  Status status{};
  if (!is_file_ || fstat(descriptor_, &status) != 0) return {};
  if (status.st_nlink == 0) return Error{path_ + " was deleted or replaced while it was written"};
  if (cut_ || static_cast<std::uint64_t>(status.st_size) < bytes_)
    return Error{path_ + " was emptied or shortened by another program while it was written"};
  return {};
}

bool FileSink::has_moved() const {
  return is_file_ && !leads_to(path_, descriptor_);
}

Result<void> FileSink::sync() {
  // EINVAL and EROFS mean a pipe or a device, which cannot be synchronized.
  if (fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS)
    return not_written(path_, errno);
  return check_whole();
}

}  // namespace galilean::mcap
