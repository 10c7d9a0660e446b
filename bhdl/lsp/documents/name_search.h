// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bhdl/lsp/documents/workspace.h"

namespace galilean::bhdl::lsp {

/// A name as a program means it.
struct Name {
  NameSpace space = NameSpace::kVariable;
  std::string text;
};

/// A name's place in a file; `range` is without quotes.
struct Occurrence {
  FilePointer file;
  ByteRange range;
  bool declares = false;
  std::string_view type;  ///< of what is declared
};

/// The name that the cursor touches, with its range in `file`.
struct NameAt {
  Name name;
  ByteRange range;
};
[[nodiscard]] std::optional<NameAt> name_at(const Workspace& workspace, const ParsedFile& file,
                                            std::size_t offset);

/// Returns every place where the name is given or used, each once. It searches the programs that
/// the file is part of, and those that share with them a file in which the name was found.
/// Declarations have `declares`.
[[nodiscard]] std::vector<Occurrence> occurrences(const Workspace& workspace,
                                                  const std::string& path, const Name& name);
/// Returns only the places where the name is given.
[[nodiscard]] std::vector<Occurrence> declarations(const Workspace& workspace,
                                                   const std::string& path, const Name& name);

}  // namespace galilean::bhdl::lsp
