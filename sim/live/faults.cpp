// SPDX-License-Identifier: BSD-3-Clause
#include "sim/live/faults.h"

#include <algorithm>
#include <cstdlib>
#include <regex>

namespace galilean::sim {

Result<DeviceFault> parse_fault(const std::string& text) {
  static const std::regex form(R"((camera|serial):([a-z0-9_]+)@(\d+(?:\.\d+)?)-(\d+(?:\.\d+)?))");
  std::smatch part;
  const Error error{"--fault " + text +
                    ": expected camera or serial, robot, seconds: camera:io@20-30"};
  if (text.size() > 200 || !std::regex_match(text, part, form)) return error;
  DeviceFault fault;
  fault.device = part[1] == "camera" ? FaultyDevice::kCamera : FaultyDevice::kSerial;
  fault.robot = part[2];
  fault.from_s = std::strtod(part[3].str().c_str(), nullptr);
  fault.until_s = std::strtod(part[4].str().c_str(), nullptr);
  if (fault.until_s <= fault.from_s) return error;
  return fault;
}

bool is_faulty(const std::vector<DeviceFault>& faults, FaultyDevice device,
               const std::string& robot, double now_s) {
  return std::any_of(faults.begin(), faults.end(), [&](const DeviceFault& fault) {
    return fault.device == device && fault.robot == robot && fault.active(now_s);
  });
}

}  // namespace galilean::sim
