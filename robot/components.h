// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/registry.h"

namespace galilean::robot {

/// Adds every component that a BHDL program of this robot may name.
void add_components(Registry& registry);

}  // namespace galilean::robot
