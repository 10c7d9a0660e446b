// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "bhdl/check/attribute_context.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"
#include "core/catalog/value.h"

namespace galilean::bhdl {

/// Returns `value`, given in `unit`, in SI. Texts, flags and names stay as they are. Units are
/// converted to SI only here.
[[nodiscard]] Value to_si(Value value, const Unit& unit);

/// Returns the attribute's value in SI, with the type that the catalog demands. If it does not fit,
/// reports what was expected and returns nothing. `context` names the component in the message.
/// Names are not looked up.
[[nodiscard]] std::optional<Value> read_value(const AttributeNode& attribute,
                                              const AttributeSpec& spec,
                                              const AttributeContext& context,
                                              Diagnostics& diagnostics);

}  // namespace galilean::bhdl
