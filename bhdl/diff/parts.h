// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bhdl/check/vocabulary.h"
#include "bhdl/diff/change.h"
#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// Adds what differs between the components of one section.
void compare_components(Change::What what, const std::vector<Component>& from,
                        const std::vector<Component>& to, const Vocabulary& vocabulary,
                        std::vector<Change>& changes);

/// Adds which states came and went and how those that stayed changed.
void compare_states(const std::vector<State>& from, const std::vector<State>& to,
                    std::vector<Change>& changes);

/// Adds what differs between the ways out of one state.
void compare_conditions(const State& from, const State& to, std::vector<Change>& changes);

}  // namespace galilean::bhdl
