// SPDX-License-Identifier: BSD-3-Clause
#include "core/broken_pipe.h"

#include <signal.h>

namespace galilean {

void ignore_broken_pipes() noexcept {
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, nullptr);
}

}  // namespace galilean
