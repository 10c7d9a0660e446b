// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// The state machine for Graphviz: a box a state, an arrow for all ways from one to another.
[[nodiscard]] std::string to_dot(const Program& program);

/// The state machine as a picture that needs nothing else. States stand in columns by how many
/// transitions the start is away; each shows its ways out in the order in which they are tried.
/// Arrows to the right leave a box at its right side, those back at its left. Within a page it
/// takes the page's colours, alone those of the viewer's light or dark scheme.
[[nodiscard]] std::string to_svg(const Program& program);

}  // namespace galilean::bhdl
