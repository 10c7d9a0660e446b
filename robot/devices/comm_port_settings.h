// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/catalog/declaration.h"

namespace galilean::robot {

/// A program's settings for the serial line (BHDL: comm_port).
struct CommPortSettings {
  std::string device;
  int baud = 115200;
  double timeout_s = 0.5;

  static void describe(Declaration<CommPortSettings>& is);
};

}  // namespace galilean::robot
