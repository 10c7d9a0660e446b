// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/check/symbols.h"
#include "bhdl/check/vocabulary.h"

namespace galilean::bhdl {

/// In `variables:` a label without a value begins a component. Where the component before has an
/// attribute of that name, its value was forgotten: reports that and gives back what follows.
void return_lost_attributes(SyntaxTree& tree, const Vocabulary& vocabulary,
                            Diagnostics& diagnostics);

/// Every name that the program gives. Reports unknown components, components in the wrong section
/// and names given twice; all of them are declared as well as can be, so that one mistake is
/// reported once.
[[nodiscard]] Symbols declare_names(const SyntaxTree& tree, const Vocabulary& vocabulary,
                                    Diagnostics& diagnostics);

}  // namespace galilean::bhdl
