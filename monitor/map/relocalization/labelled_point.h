// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/geometry.h"

namespace galilean::monitor {

/// A point that corresponds only to points of the same label. The user says in which frame it is.
struct LabelledPoint {
  Vec2 position_m;
  std::size_t label = 0;
  std::uint64_t id = 0;  ///< of the landmark, where there is one
};

/// Returns the label of a class of objects.
[[nodiscard]] inline std::size_t label_of(const std::string& object_class) {
  return std::hash<std::string>()(object_class);
}

}  // namespace galilean::monitor
