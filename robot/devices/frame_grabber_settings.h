// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/catalog/declaration.h"
#include "core/device/camera_geometry.h"

namespace galilean::robot {

/// A program's settings for the camera (BHDL: frame_grabber).
struct FrameGrabberSettings {
  std::string device;
  double timeout_s = 1;
  double view_angle_rad = CameraGeometry{}.view_angle_rad;
  double height_m = CameraGeometry{}.height_m;
  double forward_m = CameraGeometry{}.forward_m;

  static void describe(Declaration<FrameGrabberSettings>& is);
  [[nodiscard]] CameraGeometry geometry() const noexcept;
};

}  // namespace galilean::robot
