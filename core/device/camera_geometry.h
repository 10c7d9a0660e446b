// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace galilean {

/// A horizontal pinhole camera over a flat floor. The horizontal and vertical focal lengths differ,
/// because NTSC pixels are not square.
struct CameraGeometry {
  int width_px = 352;
  int height_px = 186;
  double view_angle_rad = 73.5 * 3.14159265358979323846 / 180;  ///< horizontal
  double height_m = 0.20;                                       ///< over the floor
  double forward_m = 0.10;                                      ///< in front of the robot's centre
};

}  // namespace galilean
