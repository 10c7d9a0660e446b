#pragma once

#include <string_view>

#include "bhdl/diagnostic.h"
#include "bhdl/syntax.h"
#include "bhdl/vocabulary.h"

namespace galilean::bhdl {

/// Warns of what a program without errors can hardly mean. Every warning is of something certain: a
/// robot that runs the program would show it. `tree` is what the program was read from.
void warn_of_suspects(const Program& program, const Vocabulary& vocabulary, const SyntaxTree& tree,
                      std::string_view main_file, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
