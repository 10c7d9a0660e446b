// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "bhdl/check/extension.h"
#include "bhdl/check/vocabulary.h"
#include "bhdl/program/program.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// The texts and trees behind a program, which the program itself does not hold.
struct ProgramText {
  const SyntaxTree& tree;  ///< the tree that the program was read from
  const ExtendedNames& extended;
  const std::vector<Word>& unused_constants;
  std::string_view main_file;
};

/// Warns of what a program without errors can hardly mean. Every warning is certain: a robot that
/// runs the program would show it.
void warn_of_suspects(const Program& program, const Vocabulary& vocabulary, const ProgramText& text,
                      Diagnostics& diagnostics);

}  // namespace galilean::bhdl
