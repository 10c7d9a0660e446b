// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/camera/canvas.h"

namespace galilean::sim {

/// Paints an upright rectangle: each of its bands is a trapezoid whose rows are copies of a few
/// noisy strips, which are made once a band. Columns where furniture hides it stay as they are.
void paint_face(Canvas& canvas, const Face& face, const ProjectedFace& projected);

/// Writes the depth of this face into `canvas.furniture`, for each column that it covers.
void mark_furniture(Canvas& canvas, const ProjectedFace& projected);

}  // namespace galilean::sim
