// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/geometry.h"

namespace galilean {

/// What an attribute can hold, after the loader: numbers are in SI (or the unit that the catalog
/// names where SI has none, such as ticks).
using Value =
    std::variant<bool, double, Vec2, std::string, std::vector<double>, std::vector<std::string>>;

}  // namespace galilean
