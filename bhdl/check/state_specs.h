// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// What a state and a condition take: declared like components' attributes, so that the checker and
/// the printed reference treat them alike. Their `kind` means nothing.
[[nodiscard]] const ComponentSpec& state_spec();
[[nodiscard]] const ComponentSpec& condition_spec();
/// What a variable or a schema is called by; every one of them has it, whatever its catalog says.
[[nodiscard]] const AttributeSpec& name_spec();

}  // namespace galilean::bhdl
