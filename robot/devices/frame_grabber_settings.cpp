// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/frame_grabber_settings.h"

#include "core/device/device_names.h"

namespace galilean::robot {

void FrameGrabberSettings::describe(Declaration<FrameGrabberSettings>& is) {
  using S = FrameGrabberSettings;
  is.help("The camera: colour pictures of 352 x 186 pixels.");
  is.configures(kFrameGrabberName);
  is.text(&S::device, "device", "/dev/video0",
          "a camera's device, a video or picture file, or ring:/name for the simulator's camera");
  is.number(&S::timeout_s, "timeout", unit::kSecond, 1,
            "time without a picture after which the camera counts as lost")
      .range(0.05, 120);
  is.number(&S::view_angle_rad, "view_angle", unit::kDegree, 73.5, "horizontal field of view")
      .range(1, 170);
  is.number(&S::height_m, "camera_height", unit::kCentimetre, 20, "of the lens over the floor")
      .range(1, 300)
      .role(Role::kCameraHeight);
  is.number(&S::forward_m, "camera_forward", unit::kCentimetre, 10,
            "of the lens in front of the robot's centre")
      .range(-100, 100)
      .role(Role::kCameraForward);
}

CameraGeometry FrameGrabberSettings::geometry() const noexcept {
  return {.view_angle_rad = view_angle_rad, .height_m = height_m, .forward_m = forward_m};
}

}  // namespace galilean::robot
