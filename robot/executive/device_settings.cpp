// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/device_settings.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "core/catalog/registry.h"
#include "core/device/comm_port.h"
#include "core/device/device_names.h"
#include "core/device/devices.h"
#include "core/device/frame.h"
#include "core/device/frame_grabber.h"
#include "core/device/motor_drive.h"

namespace galilean::robot {
namespace {

/// Devices that do nothing. Device settings are read before the devices exist, but the declarations
/// demand a Wiring.
class NullDevices final : public CommPort, public MotorDrive, public FrameGrabber {
 public:
  void sense(Time) noexcept override {}
  [[nodiscard]] bool healthy() const noexcept override { return false; }
  [[nodiscard]] std::string problem() const override { return "not connected"; }
  [[nodiscard]] const ControllerStatus& status() const noexcept override { return status_; }
  void command_gripper(GripperCommand) noexcept override {}
  void drive(const DriveCommand&) noexcept override {}
  void stop() noexcept override {}
  [[nodiscard]] double forward_speed_mps() const noexcept override { return 0; }
  [[nodiscard]] double turning_speed_radps() const noexcept override { return 0; }
  [[nodiscard]] double turn_radius_m() const noexcept override { return 0; }
  [[nodiscard]] const Frame& frame() const noexcept override { return frame_; }
  [[nodiscard]] const CameraGeometry& geometry() const noexcept override { return geometry_; }

 private:
  ControllerStatus status_;
  Frame frame_;
  CameraGeometry geometry_;
};

/// Returns whether a schema that a state lists needs the device.
bool is_needed(std::string_view device, const bhdl::Program& program, const Catalog& catalog) {
  std::set<std::string_view> perceptual;
  std::set<std::string_view> motor;
  for (const auto& state : program.states) {
    perceptual.insert(state.perceptual_schemas.begin(), state.perceptual_schemas.end());
    motor.insert(state.motor_schemas.begin(), state.motor_schemas.end());
  }
  const auto needs_it = [&](const std::set<std::string_view>& listed) {
    return [&](const bhdl::Component& schema) {
      const ComponentSpec* spec = catalog.find(schema.type);
      return spec != nullptr && listed.contains(schema.name) &&
             std::ranges::find(spec->needs, device) != spec->needs.end();
    };
  };
  return std::ranges::any_of(program.perceptual_schemas, needs_it(perceptual)) ||
         std::ranges::any_of(program.motor_schemas, needs_it(motor));
}

}  // namespace

DeviceSettings DeviceSettings::of(const bhdl::Program& program, const Catalog& catalog) {
  static NullDevices null_devices;  // made once, because its frame is large and nothing writes it
  VariableStore no_variables;
  const Devices no_devices{null_devices, null_devices, null_devices};
  const Wiring wiring{no_variables, no_devices, Random(0)};
  DeviceSettings result;
  for (const auto& device : program.devices) {
    if (device.type == kMotorDriveName)
      result.motor_drive = settings<MotorDriveSettings>(device.attributes, wiring);
    else if (device.type == kFrameGrabberName)
      result.frame_grabber = settings<FrameGrabberSettings>(device.attributes, wiring);
    else
      result.comm_port = settings<CommPortSettings>(device.attributes, wiring);
  }
  result.uses_camera = is_needed(kFrameGrabberName, program, catalog);
  return result;
}

}  // namespace galilean::robot
