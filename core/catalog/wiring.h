// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/random.h"
#include "core/variable/store.h"

namespace galilean {

struct Devices;

/// What a component under construction is connected to. References are checked before: every name
/// that a program gives exists and has the right type.
struct Wiring {
  VariableStore& variables;
  const Devices& devices;
  Random random;  ///< the component's own stream
};

}  // namespace galilean
