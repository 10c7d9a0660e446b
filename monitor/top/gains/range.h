// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "core/catalog/catalog.h"

namespace galilean::monitor::top {

/// How far a number can be moved, and by how much at a time.
struct Range {
  double min = 0, max = 0, step = 1;
};

/// Returns the catalog's own limits where they are of the size of the number, else as far as
/// somebody would go. `unit` is what the text writes; empty: the catalog's. The number is within.
[[nodiscard]] Range range_of(double value, std::string_view unit, const AttributeSpec& spec);

}  // namespace galilean::monitor::top
