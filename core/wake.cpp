// SPDX-License-Identifier: BSD-3-Clause
#include "core/wake.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>

namespace galilean {

Wake::Wake() : descriptor_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
}

Wake::~Wake() {
  close(descriptor_);
}

void Wake::ring() noexcept {
  eventfd_write(descriptor_, 1);
}

void Wake::clear() noexcept {
  eventfd_t rings = 0;
  eventfd_read(descriptor_, &rings);
}

}  // namespace galilean
