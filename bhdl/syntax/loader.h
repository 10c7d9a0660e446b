// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <string>

#include "bhdl/source/diagnostic.h"
#include "bhdl/source/source_provider.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// The limits of a program's size. They are many times the size of the largest program that ships,
/// and so small that a robot can check a hostile push within its memory.
inline constexpr std::size_t kMostFileBytes = 512 << 10;
inline constexpr std::size_t kMostProgramBytes = 1 << 20;
inline constexpr std::size_t kMostFiles = 64;
inline constexpr std::size_t kDeepestInclude = 16;

struct LoadedFile {
  std::string path;   ///< relative to the main file's folder
  std::string shown;  ///< the name in diagnostics
  std::string text;
};

/// A program's text with its includes put in place. The tree's views point into `files`.
struct LoadedProgram {
  std::deque<LoadedFile> files;  ///< the main file first, then in the order of reading
  SyntaxTree tree;
};

/// Returns the path that an `include` in the file at `from` names.
[[nodiscard]] std::string included_path(const std::string& from, std::string_view include);

/// Returns the tree of one file, with its includes left as they are, and reports what is wrong with
/// it.
using TreeReader = std::function<SyntaxTree(const LoadedFile& file, Diagnostics& diagnostics)>;
/// Parses the file's text. A text that cannot be BHDL gives an empty tree.
[[nodiscard]] SyntaxTree read_tree(const LoadedFile& file, Diagnostics& diagnostics);

/// Reads the main file and what it includes, each file once. A second `include` of a file adds
/// nothing. An `include` of a file that is still being read is a cycle, and an error.
[[nodiscard]] LoadedProgram load(const std::string& main_path, const SourceProvider& sources,
                                 Diagnostics& diagnostics, const TreeReader& read = read_tree);

}  // namespace galilean::bhdl
