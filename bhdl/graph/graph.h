// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// Returns the state machine for Graphviz: a box for each state, an arrow for all ways between two.
[[nodiscard]] std::string to_dot(const Program& program);

/// Returns the state machine as an SVG picture that needs no other file. A state's column is its
/// distance from the start state in transitions. Each state lists its ways out in the order in
/// which they are tried. Arrows to the right leave a box at its right side, those back at its left.
/// Within a page the picture has the page's colours. On its own it follows the viewer's light or
/// dark scheme.
[[nodiscard]] std::string to_svg(const Program& program);

}  // namespace galilean::bhdl
