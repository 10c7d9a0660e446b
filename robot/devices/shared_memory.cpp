// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/shared_memory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

namespace galilean::robot {
namespace {

Error failure(const std::string& name, const std::string& what) {
  return Error{"The shared memory " + name + " " + what + " (" + std::strerror(errno) + ")."};
}

bool has_size(int file, std::size_t bytes) {
  struct stat status {};
  return fstat(file, &status) == 0 && static_cast<std::size_t>(status.st_size) == bytes;
}

std::optional<std::span<std::byte>> map(int file, std::size_t bytes) {
  const auto mapped = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (mapped == MAP_FAILED) return std::nullopt;
  return std::span(static_cast<std::byte*>(mapped), bytes);
}

int open_shared(const std::string& name, int flags) {
  return shm_open(name.c_str(), flags | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
}

}  // namespace

Result<SharedMemory> SharedMemory::own(const std::string& name, std::size_t bytes) {
  int file = open_shared(name, O_CREAT);
  if (file < 0) return failure(name, "cannot be made");
  SharedMemory memory(file, {});
  if (flock(file, LOCK_EX | LOCK_NB) != 0)
    return failure(name, "belongs to a process that still runs: end that one, or use another name");
  // Memory that a reader may have mapped must not shrink: touching the missing end would kill the
  // reader.
  if (!has_size(file, bytes) && !has_size(file, 0)) {
    remove(name);
    return own(name, bytes);
  }
  if (ftruncate(file, static_cast<off_t>(bytes)) != 0) return failure(name, "cannot be enlarged");
  const auto mapped = map(file, bytes);
  if (!mapped) return failure(name, "cannot be mapped");
  memory.bytes_ = *mapped;
  return memory;
}

Result<SharedMemory> SharedMemory::join(const std::string& name, std::size_t bytes) {
  const int file = open_shared(name, 0);
  if (file < 0) return failure(name, "cannot be opened");
  SharedMemory memory(file, {});
  if (!has_size(file, bytes)) return Error{"The shared memory " + name + " has another layout."};
  const auto mapped = map(file, bytes);
  if (!mapped) return failure(name, "cannot be mapped");
  memory.bytes_ = *mapped;
  return memory;
}

SharedMemory::~SharedMemory() {
  release();
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : file_(std::exchange(other.file_, -1)), bytes_(std::exchange(other.bytes_, {})) {}

SharedMemory& SharedMemory::operator=(SharedMemory&& other) noexcept {
  if (this == &other) return *this;
  release();
  file_ = std::exchange(other.file_, -1);
  bytes_ = std::exchange(other.bytes_, {});
  return *this;
}

void SharedMemory::release() {
  if (!bytes_.empty()) munmap(bytes_.data(), bytes_.size());
  if (file_ >= 0) close(file_);
}

bool SharedMemory::is_current(const std::string& name) const {
  const int file = open_shared(name, 0);
  if (file < 0) return false;
  struct stat named {
  }, mine{};
  const bool known = fstat(file, &named) == 0 && fstat(file_, &mine) == 0;
  close(file);
  return known && named.st_dev == mine.st_dev && named.st_ino == mine.st_ino;
}

void SharedMemory::remove(const std::string& name) {
  shm_unlink(name.c_str());
}

}  // namespace galilean::robot
