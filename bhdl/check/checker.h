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

/// A program with the tree that it was read from. The views point into the loaded texts.
struct CheckedTree {
  Program program;
  SyntaxTree tree;  ///< constants are replaced by their values, and bases are inherited
  ExtendedNames extended;
  std::vector<Word> unused_constants;
};

/// Turns a whole program's tree into a program. All knowledge of components comes from the catalog.
/// First every name is declared. Then every attribute and reference is checked against its
/// declaration, so that the order of the text does not matter.
///
/// Errors that concern the program as a whole are reported in `main_file`. The caller fills in
/// `Program::name`, `hash` and `files`. If there are errors, the result is not to be used.
[[nodiscard]] CheckedTree check_tree(SyntaxTree tree, const std::string& main_file,
                                     const Vocabulary& vocabulary, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
