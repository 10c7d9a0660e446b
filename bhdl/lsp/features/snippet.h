// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/catalog/catalog.h"

namespace galilean::bhdl::lsp {

/// Returns the text behind an attribute's name. The places to fill in are numbered from `next` on,
/// as in the protocol's snippets, and `next` is advanced.
[[nodiscard]] std::string value_snippet(const AttributeSpec& spec, int& next);

/// Returns a component with the attributes that must be given, each on a line. A variable stands on
/// one line and needs no `end`. A state also gets its lists.
[[nodiscard]] std::string component_snippet(const ComponentSpec& spec, bool is_variable);

}  // namespace galilean::bhdl::lsp
