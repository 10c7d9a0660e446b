// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/geometry.h"

namespace galilean::monitor {

/// Returns whether two observations of one frame may be of two landmarks, as far as the observer's
/// position does not matter: they are as far apart, and are turned by no more than the observer's
/// heading may be wrong.
///
///   law     | |seen| - |known| | < 15 cm + 5 % of |seen|, which is what the camera's ranges allow;
///           angle(seen, known) < 3 heading deviations + the angle under which that appears.
///           Two observations less than 30 cm apart tell too little, and are never compatible
///   source  joint compatibility of two associations (Neira, Tardós 2001), in a closed form
///
/// `seen_m` and `known_m` are the vectors from the one to the other, with the axes of the map by
/// the heading that is believed.
[[nodiscard]] bool are_jointly_compatible(const Vec2& seen_m, const Vec2& known_m,
                                          double heading_deviation_rad);

}  // namespace galilean::monitor
