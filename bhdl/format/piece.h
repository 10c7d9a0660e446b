// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// A comment, from its semicolon to its last visible character.
struct Comment {
  std::string_view text;
  bool after_blank_line = false;
};

/// A part of the text that the formatter never cuts: a label with its colon, a value, an `end`, a
/// whole `include "x"`. It holds the comments that belong to it, and how the author broke the text
/// before it.
struct Piece {
  enum class Role { kOpen, kClose, kAttribute, kValue, kLine, kEndOfFile };

  Role role = Role::kValue;
  std::string text;  ///< the text as it will be written; empty: a close that needs no `end`
  bool begins_line = false;
  bool after_blank_line = false;
  std::vector<Comment> before;        ///< on lines of their own
  std::string_view trailing_comment;  ///< the comment behind it on its line; empty: none
  std::size_t close = 0;              ///< of an opening piece: the index of its closing one
  bool aligns_labels = false;  ///< of an opening piece: the labels of its parts stand in a column

  [[nodiscard]] bool hidden() const noexcept { return text.empty(); }
};

/// Returns the pieces of a text that has no mistake. The last is the end of the file. The quirks of
/// the published listings are gone: quotes and minus signs are plain, `end` has no colon, every
/// section is closed, and a variable is closed by what follows it. The views point into the tree's
/// text.
[[nodiscard]] std::vector<Piece> pieces_of(const ParseTree& tree);

}  // namespace galilean::bhdl
