// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/check/symbols.h"
#include "bhdl/check/vocabulary.h"

namespace galilean::bhdl {

/// Finds labels in `variables:` that have no value and so were read as components. If the component
/// before has an attribute of that name, its value was forgotten. That is reported, and the
/// attributes behind it return to that component.
void return_lost_attributes(SyntaxTree& tree, const Vocabulary& vocabulary,
                            Diagnostics& diagnostics);

/// Declares every name that the program gives. Reports unknown components, components in the wrong
/// section and names given twice. These are declared too where possible, so that one mistake is
/// reported once.
[[nodiscard]] Symbols declare_names(const SyntaxTree& tree, const Vocabulary& vocabulary,
                                    Diagnostics& diagnostics);

}  // namespace galilean::bhdl
