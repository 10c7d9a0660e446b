// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/byte_source.h"

#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/regular_file.h"

namespace galilean::mcap {

Result<FileSource> FileSource::open(const std::string& path) {
  const auto opened = open_regular_file(path);
  if (!opened) return Error{path + " cannot be read: " + opened.error().message};
  return FileSource(opened.value());
}

FileSource::FileSource(FileSource&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

FileSource::~FileSource() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::uint64_t FileSource::size() const {
  struct stat status {};
  return fstat(descriptor_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

bool FileSource::read(std::uint64_t offset, std::span<std::uint8_t> to) const {
  while (!to.empty()) {
    const ssize_t count = pread(descriptor_, to.data(), to.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    offset += static_cast<std::uint64_t>(count);
    to = to.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

bool FileSource::is_being_written() const {
  // A FileSink holds an exclusive lock as long as it lives; the kernel releases it on a kill.
  if (flock(descriptor_, LOCK_SH | LOCK_NB) != 0) return errno == EWOULDBLOCK;
  flock(descriptor_, LOCK_UN);
  return false;
}

bool MemorySource::read(std::uint64_t offset, std::span<std::uint8_t> to) const {
  if (offset > bytes_.size() || bytes_.size() - offset < to.size()) return false;
  if (!to.empty()) std::memcpy(to.data(), bytes_.data() + offset, to.size());
  return true;
}

}  // namespace galilean::mcap
