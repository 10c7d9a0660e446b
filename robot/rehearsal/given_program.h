// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/program/program.h"

namespace galilean::robot {

/// Returns the program as an expectation runs it. It starts in `from_state`. A schema for each
/// given stands first among every state's perceptual schemas, and again behind each schema that
/// writes the same variable. Given forces stand among the motor schemas in the same way. Schemas
/// and conditions therefore see what is given. Only bits that a motor schema writes are seen by the
/// motor schemas behind it until the next tick.
[[nodiscard]] bhdl::Program with_givens(bhdl::Program program, const bhdl::Expectation& expectation,
                                        const Catalog& catalog);

}  // namespace galilean::robot
