// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/opened_devices.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <variant>

#include "core/device/device_names.h"
#include "robot/executive/device_settings.h"

namespace galilean::robot {
namespace {

constexpr std::string_view kDeviceAttribute = "device";

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

/// Returns whether a program that names none gets this one.
bool is_default(const std::string& device, const ComponentSpec& spec) {
  const AttributeSpec* attribute = spec.find(kDeviceAttribute);
  if (attribute == nullptr || !attribute->default_value) return false;
  const auto* usual = std::get_if<std::string>(&*attribute->default_value);
  return usual != nullptr && *usual == device;
}

/// Returns the device that the program names; empty if it names none, or the catalog's default.
std::string named_device(std::string_view device, const bhdl::Program& program,
                         const Catalog& catalog) {
  for (const bhdl::Component& each : program.devices) {
    const ComponentSpec* spec = catalog.find(each.type);
    const Value* value = each.attributes.find(kDeviceAttribute);
    if (spec == nullptr || spec->device() != device || value == nullptr) continue;
    const auto* name = std::get_if<std::string>(value);
    if (name != nullptr && !is_default(*name, *spec)) return *name;
  }
  return "";
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

std::string OpenedDevices::overruled(const bhdl::Program& program, const Catalog& catalog) const {
  std::string named;
  const auto note = [&](std::string_view device, const std::optional<std::string>& opened) {
    const std::string wanted = opened ? "" : named_device(device, program, catalog);
    if (wanted.empty()) return;
    named += (named.empty() ? "" : ", and ") + std::string(device) + " is '" + wanted + "'";
  };
  note(kCommPortName, serial);
  note(kFrameGrabberName, camera);
  return named.empty() ? ""
                       : named + " in " + program.name +
                             ", which does not count: the command line named another";
}

DeviceSettings settings_to_open(const bhdl::Program& first, const DeviceSettings& given,
                                const Catalog& catalog) {
  DeviceSettings settings = DeviceSettings::of(first, catalog);
  if (!names(kCommPortName, first, catalog)) {
    settings.comm_port.device = given.comm_port.device;
    settings.comm_port.baud = given.comm_port.baud;
  }
  if (!names(kFrameGrabberName, first, catalog))
    settings.frame_grabber.device = given.frame_grabber.device;
  return settings;
}

}  // namespace galilean::robot
