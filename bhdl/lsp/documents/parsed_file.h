// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "bhdl/lsp/documents/mention.h"
#include "bhdl/lsp/documents/text_index.h"
#include "bhdl/syntax/reading.h"

namespace galilean::bhdl::lsp {

/// One version of a file with what was read from it. A text that cannot be BHDL (binary, too large)
/// has an empty tree. It never changes, so that its holder can read on while the editor goes on. It
/// is never copied, since the tree points into the text.
struct ParsedFile {
  /// `before` is an earlier version, whose unchanged parts are taken over. nullptr: none is known.
  ParsedFile(std::string its_path, std::string its_text, const Vocabulary& vocabulary,
             const ParsedFile* before = nullptr);
  ParsedFile(const ParsedFile&) = delete;
  ParsedFile& operator=(const ParsedFile&) = delete;

  const std::string path;
  const std::string text;
  const TextIndex index;
  const bool is_readable;  ///< false: the text may not be given to a lexer
  const Reading reading;
  const ParseTree& parse_tree = reading.tree;  ///< the tree of the text as it is written
  const std::vector<std::string> includes;     ///< paths, as the loader resolves them

  /// Return what the file says. It is computed at the first call, because after most key strokes
  /// nobody asks for it.
  [[nodiscard]] const SyntaxTree& tree() const { return content().tree; }
  [[nodiscard]] const Mentions& mentions() const { return content().mentions; }

 private:
  struct Content {
    SyntaxTree tree;
    Mentions mentions;
  };

  [[nodiscard]] const Content& content() const;

  const Vocabulary& vocabulary_;
  mutable std::once_flag is_asked_;
  mutable Content content_;
};

using FilePointer = std::shared_ptr<const ParsedFile>;

}  // namespace galilean::bhdl::lsp
