// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/catalog/catalog.h"

namespace galilean::bhdl::lsp {

/// What stands behind an attribute's name, with the places to fill in numbered from `next` on as
/// the protocol's snippets have them; `next` counts on.
[[nodiscard]] std::string value_snippet(const AttributeSpec& spec, int& next);

/// A component with what must be given, on lines of its own; a variable stands on one line and
/// needs no `end`. A state also gets its lists.
[[nodiscard]] std::string component_snippet(const ComponentSpec& spec, bool is_variable);

}  // namespace galilean::bhdl::lsp
