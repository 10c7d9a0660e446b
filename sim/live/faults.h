// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::sim {

enum class FaultyDevice { kCamera, kSerial };

/// A device of one robot that is unplugged for a while, in seconds since the simulator was ready.
struct DeviceFault {
  FaultyDevice device = FaultyDevice::kCamera;
  std::string robot;
  double from_s = 0;
  double until_s = 0;

  [[nodiscard]] bool active(double now_s) const noexcept {
    return now_s >= from_s && now_s < until_s;
  }
};

/// Parses "camera:io@20-30" or "serial:io@20-30".
[[nodiscard]] Result<DeviceFault> parse_fault(const std::string& text);

[[nodiscard]] bool is_faulty(const std::vector<DeviceFault>& faults, FaultyDevice device,
                             const std::string& robot, double now_s);

}  // namespace galilean::sim
