// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// Returns a condition in words: "gripper[0] is 1".
[[nodiscard]] std::string cause(const Condition& condition);

/// Writes a program's state machine: {name, hash, start_state, states, transitions, on_swap}.
/// States have name, file, line and their two lists of schemas. Transitions have from_state,
/// to_state, file, line, cause and the condition's attributes.
void to_json(nlohmann::json& json, const Program& program);

}  // namespace galilean::bhdl
