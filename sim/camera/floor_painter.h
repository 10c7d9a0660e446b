// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/camera/canvas.h"

namespace galilean::sim {

/// Blends a flat disc on the floor towards `target`: 0 is shadow, 255 the mirror image of a lamp.
/// pixel += (target - pixel) · weight / 256
struct FloorSpot {
  Eigen::Vector2f in_camera_m;
  float radius_m = 0;
  int target = 0;
  int weight = 0;
};
void paint_spot(Canvas& canvas, const FloorSpot& spot);

}  // namespace galilean::sim
