// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bhdl/lsp/workspace.h"

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

/// The name that the cursor touches, with its range in `file`; nothing if there is none.
struct NameAt {
  Name name;
  ByteRange range;
};
[[nodiscard]] std::optional<NameAt> name_at(const Workspace& workspace, const ParsedFile& file,
                                            std::size_t offset);

/// Everywhere that the name is given or used in the programs that the file is part of, and in those
/// that share a place found so with them. Each place once; declarations have `declares`.
[[nodiscard]] std::vector<Occurrence> occurrences(const Workspace& workspace,
                                                  const std::string& path, const Name& name);
/// Only where it is given.
[[nodiscard]] std::vector<Occurrence> declarations(const Workspace& workspace,
                                                   const std::string& path, const Name& name);

}  // namespace galilean::bhdl::lsp
