// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "bhdl/check/extension.h"
#include "bhdl/check/vocabulary.h"
#include "bhdl/program/program.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// A program beside what it was read from. The views point into the loaded texts.
struct CheckedTree {
  Program program;
  SyntaxTree tree;  ///< constants and bases are put in
  Bases bases;
  std::vector<Word> unused_constants;
};

/// Turns a whole program's tree into a program. All that it knows of components comes from the
/// catalog. First every name is declared, then every attribute and reference is held against its
/// declaration, so that the order of the text does not matter.
///
/// `main_file` is where a fault of the whole is reported. `Program::name`, `hash` and `files` are
/// the caller's to fill in; where there are errors the result is not to be used.
[[nodiscard]] CheckedTree check_tree(SyntaxTree tree, const std::string& main_file,
                                     const Vocabulary& vocabulary, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
