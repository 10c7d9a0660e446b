// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/perceptual/perspective.h"

#include <cmath>

namespace galilean::robot {

void Perspective::draw(const CameraGeometry& camera, Frame& frame) const {
  const double half_width = std::tan(camera.view_angle_rad / 2);
  const double half_height = half_width * 3 / 4;  // with square pixels the picture would be 4:3
  auto* out = frame.rgb.data();
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const double right = half_width * (2 * (x + 0.5) / camera.width_px - 1);
      const double up = half_height * (1 - 2 * (y + 0.5) / camera.height_px);
      const Colour colour = trace(camera, right, up).colour;
      *out++ = colour.red;
      *out++ = colour.green;
      *out++ = colour.blue;
    }
}

Perspective::Hit Perspective::trace(const CameraGeometry& camera, double right, double up) const {
  Hit nearest{room_depth_m, wall};
  if (up < 0 && camera.height_m / -up < nearest.depth_m) nearest = {camera.height_m / -up, floor};
  if (up > 0 && (ceiling_m - camera.height_m) / up < nearest.depth_m)
    nearest = {(ceiling_m - camera.height_m) / up, ceiling};
  for (const Panel& panel : panels) {
    const double depth = panel.depth_m - camera.forward_m;
    const double x = depth * right;
    const double z = camera.height_m + depth * up;
    if (depth > 0 && depth <= nearest.depth_m && x >= panel.left_m && x <= panel.right_m &&
        z >= panel.bottom_m && z <= panel.top_m)
      nearest = {depth, panel.colour};
  }
  for (const Cylinder& cylinder : cylinders) trace_cylinder(cylinder, camera, right, up, nearest);
  return nearest;
}

void Perspective::trace_cylinder(const Cylinder& cylinder, const CameraGeometry& camera,
                                 double right, double up, Hit& nearest) const {
  const Vec2 centre = cylinder.centre_m - Vec2(0, camera.forward_m);
  const Vec2 ray(right, 1);
  const double a = ray.squaredNorm();
  const double b = ray.dot(centre);
  const double c = centre.squaredNorm() - cylinder.radius_m * cylinder.radius_m;
  if (b * b < a * c) return;
  const double depth = (b - std::sqrt(b * b - a * c)) / a;
  const double z = camera.height_m + depth * up;
  const bool side = depth > 0 && z >= 0 && z <= cylinder.height_m;
  if (side && depth < nearest.depth_m) nearest = {depth, cylinder.colour};
  const double lid = up < 0 ? (cylinder.height_m - camera.height_m) / up : -1;
  const bool on_lid = lid > 0 && (ray * lid - centre).norm() <= cylinder.radius_m;
  if (on_lid && lid < nearest.depth_m) nearest = {lid, cylinder.colour};
}

}  // namespace galilean::robot
