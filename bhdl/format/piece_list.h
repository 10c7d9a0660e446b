// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/format/gap.h"
#include "bhdl/format/piece.h"
#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// Makes pieces of tokens. No comment between two pieces is lost.
class PieceList {
 public:
  /// Requires: `tree` outlives this object.
  explicit PieceList(const ParseTree& tree) : tree_(tree) {}

  /// Returns the number of the token that is taken next.
  [[nodiscard]] std::uint32_t next() const noexcept { return next_; }
  [[nodiscard]] bool at(TokenKind kind) const noexcept { return tree_.tokens[next_].kind == kind; }
  [[nodiscard]] Piece& last() { return pieces_.back(); }
  [[nodiscard]] Piece& at(std::size_t i) { return pieces_[i]; }
  [[nodiscard]] std::vector<Piece> take() && { return std::move(pieces_); }

  /// Takes the first token of a piece.
  const Token& begin(Piece::Role role);
  /// Takes a further token of the last piece. Comments between the two are put behind the whole
  /// piece.
  const Token& more();

  /// Takes a block's label. Returns the index of its piece.
  std::size_t open(const std::string& word);
  /// Takes the block's `end`.
  void close(std::size_t opened);
  /// Takes the block's `end`, which will not be written.
  void drop_end(std::size_t opened);
  /// Gives the `end` that was dropped last to this block. It is written.
  void return_end(std::size_t opened);
  /// Closes a block that the text leaves open. `end` may be empty.
  void add_close(std::size_t opened, const std::string& end);

 private:
  [[nodiscard]] Gap gap() const { return read_gap(tree_.gap_before(next_)); }
  void add_remark(const Comment& comment);
  void take_colon();

  const ParseTree& tree_;
  std::uint32_t next_ = 0;
  std::vector<Piece> pieces_;
  std::vector<Comment> pending_;  ///< for the next piece
  std::size_t last_written_ = 0;  ///< the last piece that stands in the text and will be written
};

}  // namespace galilean::bhdl
