// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/limits/descriptors.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <utility>

namespace galilean::monitor {

Result<std::size_t> raise_descriptor_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return kFewestDescriptors;
  const auto wanted = std::min<rlim_t>(limit.rlim_max, kMostDescriptors);
  if (limit.rlim_cur < wanted) {
    rlimit raised = limit;
    raised.rlim_cur = wanted;
    if (setrlimit(RLIMIT_NOFILE, &raised) == 0) limit = raised;
  }
  if (limit.rlim_cur < kFewestDescriptors)
    return Error{"only " + std::to_string(limit.rlim_cur) +
                 " files and connections may be open at once, and the monitor needs " +
                 std::to_string(kFewestDescriptors) + "; raise it with 'ulimit -n 1024'"};
  return static_cast<std::size_t>(limit.rlim_cur);
}

void ReserveDescriptor::take() {
  if (descriptor_ < 0) descriptor_ = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
}

bool ReserveDescriptor::give() {
  if (descriptor_ < 0) return false;
  ::close(std::exchange(descriptor_, -1));
  return true;
}

}  // namespace galilean::monitor
