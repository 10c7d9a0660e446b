// SPDX-License-Identifier: BSD-3-Clause
#include "core/standard_output.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>

namespace galilean {
namespace {

/// Takes the numbers of standard descriptors that are closed. What is printed there fails, because
/// they are for reading only.
void occupy_standard_descriptors() noexcept {
  int descriptor = 0;
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = open("/dev/null", O_RDONLY);
  if (descriptor >= 0) close(descriptor);
}

/// Returns whether standard output is a pipe or a socket that nobody reads any more.
bool nobody_reads() noexcept {
  pollfd event{STDOUT_FILENO, POLLOUT, 0};
  return poll(&event, 1, 0) > 0 && (event.revents & (POLLERR | POLLHUP)) != 0;
}

/// Returns why standard output cannot be written: by the write that has just failed, or by another
/// one of nothing. Returns 0 where neither tells.
int reason_now(int failure) noexcept {
  if (failure != 0) return failure;
  errno = 0;
  return write(STDOUT_FILENO, "", 0) < 0 ? errno : 0;
}

void flush_and_tell(int status, void*) {
  errno = 0;
  std::cout.flush();
  const int failure = std::fflush(stdout) != 0 ? errno : 0;
  if (failure == 0 && !std::cout.bad() && std::ferror(stdout) == 0) return;
  if (failure == EPIPE || nobody_reads()) return;
  const int reason = reason_now(failure);
  std::fprintf(stderr, "%s: standard output cannot be written%s%s; what was printed is not whole\n",
               program_invocation_short_name, reason != 0 ? ": " : "",
               reason != 0 ? std::strerror(reason) : "");
  std::fflush(stderr);
  if (status == EXIT_SUCCESS) _exit(EXIT_FAILURE);
}

}  // namespace

void tell_unwritten_output() noexcept {
  static const bool is_told = [] {
    occupy_standard_descriptors();
    return on_exit(flush_and_tell, nullptr) == 0;
  }();
  static_cast<void>(is_told);
}

}  // namespace galilean
