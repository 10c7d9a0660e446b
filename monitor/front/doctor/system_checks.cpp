// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "monitor/front/doctor/checks.h"

namespace galilean::front {
namespace {

/// A file descriptor that the destructor closes.
struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

}  // namespace

Check check_pseudo_terminals() {
  const Descriptor master{posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)};
  if (master.number >= 0 && grantpt(master.number) == 0 && unlockpt(master.number) == 0)
    return {"pseudo-terminals", true, "the simulator can give robots serial lines"};
  return {"pseudo-terminals", false, std::strerror(errno),
          "mount devpts on /dev/pts; in a container, run it with a /dev/ptmx"};
}

Check check_shared_memory() {
  constexpr off_t kRing = 4 << 20;
  const std::string name = "/galilean-doctor-" + std::to_string(getpid());
  const Descriptor memory{shm_open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600)};
  const int opened = errno;
  if (memory.number < 0)
    return {"shared memory", false, std::strerror(opened), "mount a tmpfs on /dev/shm"};
  const int problem = posix_fallocate(memory.number, 0, kRing);
  shm_unlink(name.c_str());
  if (problem == 0) return {"shared memory", true, "the simulator can give robots cameras"};
  return {"shared memory", false, std::strerror(problem),
          "make /dev/shm larger: 4 MiB a robot (in a container, --shm-size)"};
}

}  // namespace galilean::front
