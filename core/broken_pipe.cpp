// SPDX-License-Identifier: BSD-3-Clause
#include "core/broken_pipe.h"

#include <signal.h>

namespace galilean {

namespace {

void ignore(int signal) noexcept {
  struct sigaction action {};
  action.sa_handler = SIG_IGN;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void ignore_broken_pipes() noexcept {
  ignore(SIGPIPE);
}

void ignore_file_size_limit() noexcept {
  ignore(SIGXFSZ);
}

}  // namespace galilean
