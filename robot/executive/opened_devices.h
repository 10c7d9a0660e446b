// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "bhdl/program/program.h"
#include "core/catalog/catalog.h"
#include "core/result.h"
#include "robot/executive/device_settings.h"

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
  /// Returns a sentence on the devices that the program names and does not get, because the command
  /// line named them; empty if there are none.
  [[nodiscard]] std::string overruled(const bhdl::Program& program, const Catalog& catalog) const;
};

/// Returns the settings with which a robot opens its devices for `first`: its own, but where it
/// does not name a device, that of `given`. A program that was pushed and runs again after a crash
/// took what was open, which is what the program of the command line names. Requires: both were
/// checked against `catalog`.
[[nodiscard]] DeviceSettings settings_to_open(const bhdl::Program& first,
                                              const DeviceSettings& given, const Catalog& catalog);

}  // namespace galilean::robot
