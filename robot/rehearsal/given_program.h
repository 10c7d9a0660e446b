// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/program/program.h"

namespace galilean::robot {

/// The program as an expectation wants it run: it starts in `from_state`, and what is given stands
/// first among every state's perceptual schemas and again behind each that writes the same
/// variable; forces so among the motor schemas. So nobody sees anything else, neither schemas nor
/// conditions; bits that a motor schema writes are seen by those behind it until the next tick.
[[nodiscard]] bhdl::Program with_givens(bhdl::Program program, const bhdl::Expectation& expectation,
                                        const Catalog& catalog);

}  // namespace galilean::robot
