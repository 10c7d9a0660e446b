// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/commands/push_options.h"

namespace galilean::monitor {

struct DirectSwapOptions {
  PushOptions push;
  std::string file;
  double timeout_s = 2;  ///< time that robots have to answer
  int domain = -1;
  std::string key_file;  ///< of the key that signs the push; empty: the operator's, if there is one
};

/// Pushes a program over DDS without a monitor, and so without a trial and a canary. Prints the
/// robots' answers. Returns the process' exit code.
[[nodiscard]] int swap_directly(const DirectSwapOptions& options);

}  // namespace galilean::monitor
