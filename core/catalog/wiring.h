// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/random.h"
#include "core/variable/store.h"

namespace galilean {

struct Devices;

/// What a component under construction is connected to. Requires: the checker has found every name
/// that the program gives, and its type is right.
struct Wiring {
  VariableStore& variables;
  const Devices& devices;
  Random random;  ///< the component's own stream
};

}  // namespace galilean
