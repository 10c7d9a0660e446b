// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "sim/world/physics.h"

namespace galilean::sim {

/// Returns what stands where `body` would stand at `pose`, or nothing if the place is free.
[[nodiscard]] std::optional<BodyTag> occupant(const b2World& world, const b2Body& body,
                                              const Pose2& pose);
/// The same for a disc that is not in the world yet.
[[nodiscard]] std::optional<BodyTag> occupant(const b2World& world, const Vec2& at_m,
                                              double radius_m);

}  // namespace galilean::sim
