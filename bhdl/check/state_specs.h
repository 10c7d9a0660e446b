// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// What a state and a condition take. They are declared like components, so that the checker and
/// the printed reference treat them alike. Their `kind` has no meaning.
[[nodiscard]] const ComponentSpec& state_spec();
[[nodiscard]] const ComponentSpec& condition_spec();
/// Returns the declaration of `name`. Every variable and schema has one, whatever its catalog says.
[[nodiscard]] const AttributeSpec& name_spec();

}  // namespace galilean::bhdl
