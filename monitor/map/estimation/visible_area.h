// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/geometry.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// The far end of the visible area. A blob that is further away may be too small to be detected.
inline constexpr double kVisibleTo_m = 2.0;

/// Returns whether the camera would surely have detected an object that stands at `in_robot_m`
/// (robot frame: x forward, y left). That is not so where the object is so near that its blob
/// leaves the picture, where it is beyond kVisibleTo_m, at the picture's edge, and behind another
/// object of the frame.
[[nodiscard]] bool in_visible_area(const msg::Sightings& frame, const Vec2& in_robot_m);

}  // namespace galilean::monitor
