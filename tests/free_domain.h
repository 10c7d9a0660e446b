// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

namespace galilean {

/// Returns a DDS domain that no other test on this machine uses, not even one of another checkout.
/// It is held until this process ends. Each call returns another one. tests/tools/domain.mjs does
/// the same for scripts. Errors: throws if all are taken.
[[nodiscard]] inline int free_domain() {
  constexpr int kFirst = 20, kCount = 80;
  static int next = getpid() % kCount;
  for (int tried = 0; tried < kCount; ++tried) {
    const int domain = kFirst + next++ % kCount;
    const std::string lock = "/tmp/galilean-domain-" + std::to_string(domain);
    const int file = open(lock.c_str(), O_RDONLY | O_CREAT | O_CLOEXEC, 0644);
    if (file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0) return domain;
    if (file >= 0) close(file);
  }
  throw std::runtime_error("tests hold every DDS domain: see who holds /tmp/galilean-domain-*");
}

}  // namespace galilean
