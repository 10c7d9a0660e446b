// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "bhdl/check/owner.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"
#include "core/catalog/value.h"

namespace galilean::bhdl {

/// `value` in SI, given in `unit`; texts, flags and names stay as they are. The only place where
/// units are converted.
[[nodiscard]] Value to_si(Value value, const Unit& unit);

/// What an attribute was given, as the catalog types it and in SI. Whatever does not fit is
/// reported with what was expected; `owner` names the component in the message. Names are not
/// looked up.
[[nodiscard]] std::optional<Value> read_value(const AttributeNode& attribute,
                                              const AttributeSpec& spec, const Owner& owner,
                                              Diagnostics& diagnostics);

}  // namespace galilean::bhdl
