// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/device/camera_geometry.h"
#include "core/device/frame.h"
#include "core/geometry.h"

namespace galilean::robot {

struct Colour {
  std::uint8_t red, green, blue;
};

/// An upright cylinder on the floor. Positions are in the robot frame (x right, y forward) [m].
struct Cylinder {
  Vec2 centre_m;
  double radius_m;
  double height_m;
  Colour colour;
};

/// An upright rectangle square to the camera's axis, from `left_m` to `right_m` at `depth_m` in
/// front of the robot's centre.
struct Panel {
  double left_m, right_m, depth_m, bottom_m, top_m;
  Colour colour;
};

/// Draws the picture that a pinhole camera really takes. It traces one ray through the middle of
/// every pixel, which is other arithmetic than the camera model's.
class Perspective {
 public:
  std::vector<Cylinder> cylinders;
  std::vector<Panel> panels;
  Colour floor{120, 118, 115};
  Colour wall{190, 190, 185};
  Colour ceiling{190, 190, 185};
  double room_depth_m = 8;
  double ceiling_m = 2.6;

  void draw(const CameraGeometry& camera, Frame& frame) const;

 private:
  /// The first hit along a ray (right, up, with depth 1 forward) from the camera.
  struct Hit {
    double depth_m;
    Colour colour;
  };
  [[nodiscard]] Hit trace(const CameraGeometry& camera, double right, double up) const;
  void trace_cylinder(const Cylinder& cylinder, const CameraGeometry& camera, double right,
                      double up, Hit& nearest) const;
};

}  // namespace galilean::robot
