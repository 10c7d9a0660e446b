// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace galilean::mcap {

int open_output_pipe(const std::string& path) {
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

int open_output_file(const std::string& path, bool may_be_there, bool& made) {
  constexpr int kHow = O_WRONLY | O_CREAT | O_CLOEXEC;
  const int descriptor = open(path.c_str(), kHow | O_EXCL, 0644);
  made = descriptor >= 0;
  return !made && errno == EEXIST && may_be_there ? open(path.c_str(), kHow, 0644) : descriptor;
}

bool lock_output(int descriptor) {
  constexpr int kTries = 20;
  constexpr auto kLookEach = std::chrono::milliseconds(10);
  for (int i = 0; i < kTries; ++i) {
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return true;
    std::this_thread::sleep_for(kLookEach);
  }
  return false;
}

}  // namespace galilean::mcap
