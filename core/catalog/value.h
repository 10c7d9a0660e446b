// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/geometry.h"

namespace galilean {

/// What an attribute holds after the check. Numbers are in SI, or in the catalog's unit where SI
/// has none, such as ticks.
using Value =
    std::variant<bool, double, Vec2, std::string, std::vector<double>, std::vector<std::string>>;

}  // namespace galilean
