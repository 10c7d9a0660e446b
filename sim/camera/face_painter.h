// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/camera/canvas.h"

namespace galilean::sim {

/// Paints an upright rectangle: each of its bands is a trapezoid whose rows are copies of a few
/// noisy strips, which are made once a band. Columns where furniture hides it stay as they are.
void paint_face(Canvas& canvas, const Face& face, const ProjectedFace& projected);

/// Enters the 1/depth [1/m] of this face into `canvas.furniture` in each column that it covers. The
/// nearest face of a column counts.
void mark_furniture(Canvas& canvas, const ProjectedFace& projected);

}  // namespace galilean::sim
