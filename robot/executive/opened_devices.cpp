// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/opened_devices.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "core/device/device_names.h"
#include "robot/executive/device_settings.h"

namespace galilean::robot {
namespace {

bool names(std::string_view device, const bhdl::Program& program, const Catalog& catalog) {
  return std::ranges::any_of(program.devices, [&](const bhdl::Component& each) {
    const ComponentSpec* spec = catalog.find(each.type);
    return spec != nullptr && spec->device() == device;
  });
}

bool is_other(const std::string& device, const std::string& opened) {
  return std::filesystem::path(device).lexically_normal() !=
         std::filesystem::path(opened).lexically_normal();
}

std::string difference(std::string_view device, const std::string& wanted,
                       const std::string& opened) {
  return std::string(device) + " is " + wanted + " in this program, and this robot runs on " +
         opened;
}

}  // namespace

Result<void> OpenedDevices::accept(const bhdl::Program& program, const Catalog& catalog) const {
  const DeviceSettings wanted = DeviceSettings::of(program, catalog);
  std::string differences;
  const auto note = [&differences](const std::string& found) {
    differences += (differences.empty() ? "" : "; ") + found;
  };
  if (names(kCommPortName, program, catalog)) {
    if (serial && is_other(wanted.comm_port.device, *serial))
      note(difference(kCommPortName, "'" + wanted.comm_port.device + "'", "'" + *serial + "'"));
    if (wanted.comm_port.baud != baud)
      note(difference(kCommPortName, std::to_string(wanted.comm_port.baud) + " baud",
                      std::to_string(baud) + " baud"));
  }
  if (camera && names(kFrameGrabberName, program, catalog) &&
      is_other(wanted.frame_grabber.device, *camera))
    note(difference(kFrameGrabberName, "'" + wanted.frame_grabber.device + "'",
                    "'" + *camera + "'"));
  if (differences.empty()) return {};
  return Error{differences +
               ": devices are opened when a robot starts, so restart it with this program"};
}

}  // namespace galilean::robot
