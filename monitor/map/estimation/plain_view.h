#pragma once

#include "core/geometry.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

inline constexpr double kPlainViewTo_m = 2.0;  ///< further away, a blob may be too small

/// What a camera must see if it is there, `from_robot_m` (x forward, y left): not so near that the
/// blob leaves the picture, not so far that it is small, not at the picture's edge, and not hidden.
[[nodiscard]] bool in_plain_view(const msg::Sightings& frame, const Vec2& from_robot_m);

}  // namespace galilean::monitor
