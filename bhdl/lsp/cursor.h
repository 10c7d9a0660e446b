// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bhdl/lsp/block.h"

namespace galilean::bhdl::lsp {

/// Where in a program's structure a cursor is, as what stands before it tells, so that it is known
/// in a text that does not parse.
struct Cursor {
  /// What stands around the cursor, the innermost last; empty outside every section.
  std::vector<Block> around;
  std::string_view attribute;                ///< whose value is being written; empty: none is
  std::vector<std::string_view> values;      ///< of that attribute, before the cursor
  std::set<std::string_view> given;          ///< attributes of the innermost block, also behind
  ByteRange word;                            ///< what is being written, up to the cursor
  bool in_text = false;                      ///< it is a text; `word` begins behind its quote
  bool in_comment = false;                   ///< where nothing is to be completed
  TokenKind behind = TokenKind::kEndOfFile;  ///< the token before it

  [[nodiscard]] const Block* innermost() const noexcept {
    return around.empty() ? nullptr : &around.back();
  }
};

/// The cursor's views point into the tree's text.
[[nodiscard]] Cursor cursor_at(const ParseTree& tree, std::size_t offset,
                               const Vocabulary& vocabulary);

}  // namespace galilean::bhdl::lsp
