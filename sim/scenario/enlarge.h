// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/scenario/scenario.h"

namespace galilean::sim {

/// Returns the scenario with a place for each of so many robots. If it has too few places, it is
/// laid beside itself as often as is needed, in rows, without walls between: what stands and lies
/// in it is there once in each copy. The first copy is where the scenario was.
[[nodiscard]] Scenario enlarged_for(const Scenario& scenario, std::size_t robots);

}  // namespace galilean::sim
