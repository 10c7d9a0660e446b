// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/commands/push_options.h"

namespace galilean::monitor {

struct DirectSwapOptions {
  PushOptions push;
  std::string file;
  double timeout_s = 2;  ///< that robots may take to answer
  int domain = -1;
};

/// Pushes a program over DDS, without a monitor: no trial, no canary. Returns the exit code.
[[nodiscard]] int swap_directly(const DirectSwapOptions& options);

}  // namespace galilean::monitor
