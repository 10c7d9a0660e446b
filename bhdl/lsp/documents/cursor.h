// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bhdl/lsp/documents/block.h"

namespace galilean::bhdl::lsp {

/// Where in a program's structure a cursor is. Only the text before it decides, so that it is known
/// in a text that does not parse.
struct Cursor {
  /// The blocks around the cursor, the innermost last. Empty outside every section.
  std::vector<Block> around;
  std::string_view attribute;                ///< the attribute whose value is being written; empty:
                                             ///< none
  std::vector<std::string_view> values;      ///< values of that attribute before the cursor
  std::set<std::string_view> given;          ///< attributes of the innermost block, also behind the
                                             ///< cursor
  ByteRange word;                            ///< the word that is being written, up to the cursor
  bool in_text = false;                      ///< that word is a text, and begins behind its quote
  bool in_comment = false;                   ///< nothing is to be completed
  TokenKind behind = TokenKind::kEndOfFile;  ///< the token before the cursor

  [[nodiscard]] const Block* innermost() const noexcept {
    return around.empty() ? nullptr : &around.back();
  }
};

/// Returns the cursor at `offset`. Its views point into the tree's text.
[[nodiscard]] Cursor cursor_at(const ParseTree& tree, std::size_t offset,
                               const Vocabulary& vocabulary);

}  // namespace galilean::bhdl::lsp
