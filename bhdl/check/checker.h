#pragma once

#include <string>

#include "bhdl/check/vocabulary.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// How much is looked for. Warnings take a fifth of the time, and change nothing of a program.
enum class Depth { kErrors, kErrorsAndWarnings };

/// Turns a whole program's tree into a program. All that it knows of components comes from the
/// catalog. First every name is declared, then every attribute and reference is held against its
/// declaration, so that the order of the text does not matter.
///
/// `main_file` is where a fault of the whole is reported. `Program::name`, `hash` and `files` are
/// the caller's to fill in; where there are errors the result is not to be used.
[[nodiscard]] Program check_tree(SyntaxTree tree, const std::string& main_file,
                                 const Vocabulary& vocabulary, Diagnostics& diagnostics,
                                 Depth depth = Depth::kErrorsAndWarnings);

}  // namespace galilean::bhdl
