// SPDX-License-Identifier: BSD-3-Clause
// A library for LD_PRELOAD that makes faults in one process: its clock is set, or its disk fails.
// The file that FAULT_SHIM names holds three numbers of 64 bits, which may change at any time: by
// how many nanoseconds CLOCK_REALTIME is ahead, and the errno with which writing and syncing fail,
// or 0. They fail for files whose path begins with FAULT_SHIM_FILES. Waits until a time of the
// clock go by the clock that is set, as those of DDS do.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>

namespace {

struct Orders {
  std::atomic<std::int64_t> clock_ahead_ns;
  std::atomic<std::int64_t> write_error;
  std::atomic<std::int64_t> sync_error;
};

Orders* map_orders() {
  const char* const name = std::getenv("FAULT_SHIM");
  const int file = name ? open(name, O_RDONLY | O_CLOEXEC) : -1;
  if (file < 0) return nullptr;
  void* const memory = mmap(nullptr, sizeof(Orders), PROT_READ, MAP_SHARED, file, 0);
  close(file);
  return memory == MAP_FAILED ? nullptr : static_cast<Orders*>(memory);
}

/// Returns null where nothing is ordered.
const Orders* orders() {
  static const Orders* const mapped = map_orders();
  return mapped;
}

bool is_concerned(int file) {
  static const char* const begin = std::getenv("FAULT_SHIM_FILES");
  if (!begin) return false;
  std::array<char, 64> link{};
  std::array<char, 4096> path{};
  std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", file);
  const ssize_t size = readlink(link.data(), path.data(), path.size());
  return size > 0 &&
         std::string_view(path.data(), static_cast<std::size_t>(size)).starts_with(begin);
}

/// Returns whether a call for `file` is to fail with `error`, which then is errno.
bool fails(int file, std::int64_t error) {
  if (error == 0 || !is_concerned(file)) return false;
  errno = static_cast<int>(error);
  return true;
}
bool write_fails(int file) {
  return orders() && fails(file, orders()->write_error);
}
bool sync_fails(int file) {
  return orders() && fails(file, orders()->sync_error);
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

constexpr std::int64_t kSecond_ns = 1'000'000'000;

std::int64_t ns_of(const timespec& time) {
  return time.tv_sec * kSecond_ns + time.tv_nsec;
}

std::int64_t true_ns(clockid_t clock) {
  timespec now{};
  syscall(SYS_clock_gettime, clock, &now);
  return ns_of(now);
}

/// Waits until a time of the clock that is set. That may be set again meanwhile, so no wait is
/// longer than kLongestWait_ns: it ends as one that was woken for nothing, which all who wait must
/// expect.
int wait_until_set_time(pthread_cond_t* condition, pthread_mutex_t* mutex, const timespec& end) {
  constexpr std::int64_t kLongestWait_ns = 50'000'000;
  const std::int64_t left_ns =
      ns_of(end) - true_ns(CLOCK_REALTIME) - orders()->clock_ahead_ns.load();
  const std::int64_t until_ns =
      true_ns(CLOCK_MONOTONIC) + std::clamp<std::int64_t>(left_ns, 0, kLongestWait_ns);
  const timespec until{until_ns / kSecond_ns, until_ns % kSecond_ns};
  const int result = pthread_cond_clockwait(condition, mutex, CLOCK_MONOTONIC, &until);
  return result == ETIMEDOUT && left_ns > kLongestWait_ns ? 0 : result;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const long result = syscall(SYS_clock_gettime, clock, time);
  const bool is_set = clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE;
  if (result != 0 || !is_set || !orders()) return static_cast<int>(result);
  const std::int64_t now_ns = ns_of(*time) + orders()->clock_ahead_ns;
  time->tv_sec = now_ns / kSecond_ns;
  time->tv_nsec = now_ns % kSecond_ns;
  return 0;
}

int pthread_cond_timedwait(pthread_cond_t* __restrict condition, pthread_mutex_t* __restrict mutex,
                           const timespec* __restrict end) {
  // A condition may go by the clock that nobody can set, whose times are less than thirty years.
  constexpr std::int64_t kThirtyYears_s = 946'684'800;
  if (end->tv_sec < kThirtyYears_s)
    return pthread_cond_clockwait(condition, mutex, CLOCK_MONOTONIC, end);
  if (!orders()) return pthread_cond_clockwait(condition, mutex, CLOCK_REALTIME, end);
  return wait_until_set_time(condition, mutex, *end);
}

ssize_t write(int file, const void* bytes, size_t size) {
  static auto* const real = next<ssize_t(int, const void*, size_t)>("write");
  return write_fails(file) ? -1 : real(file, bytes, size);
}

ssize_t writev(int file, const iovec* pieces, int count) {
  static auto* const real = next<ssize_t(int, const iovec*, int)>("writev");
  return write_fails(file) ? -1 : real(file, pieces, count);
}

ssize_t pwrite(int file, const void* bytes, size_t size, off_t offset) {
  static auto* const real = next<ssize_t(int, const void*, size_t, off_t)>("pwrite");
  return write_fails(file) ? -1 : real(file, bytes, size, offset);
}

ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t offset) {
  static auto* const real = next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64");
  return write_fails(file) ? -1 : real(file, bytes, size, offset);
}

int fsync(int file) {
  static auto* const real = next<int(int)>("fsync");
  return sync_fails(file) ? -1 : real(file);
}

int fdatasync(int file) {
  static auto* const real = next<int(int)>("fdatasync");
  return sync_fails(file) ? -1 : real(file);
}

}  // extern "C"
