// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/camera/canvas.h"

namespace galilean::sim {

/// Paints an upright cylinder column by column: where the column's ray enters the circle gives the
/// lower edge, so that its lowest pixel lies at r = h / tan θ of its nearest point.
void paint_disc(Canvas& canvas, const Disc& disc, const Eigen::Vector2f& in_camera_m);

}  // namespace galilean::sim
