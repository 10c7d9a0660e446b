// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "bhdl/program/program.h"
#include "core/catalog/catalog.h"
#include "core/result.h"

namespace galilean::robot {

/// The devices that a robot opened at its start, as its first program named them. It opens no
/// others while it runs.
struct OpenedDevices {
  std::optional<std::string> serial;  ///< nothing: the command line named it, and programs do not
  std::optional<std::string> camera;  ///< the same
  int baud = 115200;

  /// Returns whether a robot with these devices may run the program. A program that does not name
  /// a device takes the one that is open. Errors: the program names another device, or another
  /// speed of the line. The error names both, and says what to do.
  [[nodiscard]] Result<void> accept(const bhdl::Program& program, const Catalog& catalog) const;
};

}  // namespace galilean::robot
