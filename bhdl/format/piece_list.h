#pragma once

#include "bhdl/format/piece.h"
#include "bhdl/format/trivia.h"
#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {

/// Makes pieces of tokens and sees to it that no comment between two of these is lost.
class PieceList {
 public:
  PieceList(std::string_view file, std::string_view text)
      : text_(text), tree_{text, {}, {}}, tokens_(file, tree_, diagnostics_) {}
  PieceList(const PieceList&) = delete;
  PieceList& operator=(const PieceList&) = delete;

  [[nodiscard]] const TokenStream& tokens() const noexcept { return tokens_; }
  [[nodiscard]] Piece& last() { return pieces_.back(); }
  [[nodiscard]] Piece& at(std::size_t i) { return pieces_[i]; }
  [[nodiscard]] std::vector<Piece> take() && { return std::move(pieces_); }

  /// Takes the first token of a piece.
  Token begin(Piece::Role role);
  /// Takes a further token of the last piece; comments between the two go behind the whole.
  Token more();

  /// Takes a block's label and tells where its piece is.
  std::size_t open(const std::string& word);
  /// Takes the block's `end`.
  void close(std::size_t opened);
  /// Takes the block's `end`, which will not be written.
  void drop_end(std::size_t opened);
  /// The `end` that was dropped last is this block's and will be written.
  void return_end(std::size_t opened);
  /// Closes a block that the text leaves open; `end` may be empty.
  void add_close(std::size_t opened, const std::string& end);

 private:
  [[nodiscard]] Trivia trivia_before(const Token& token);
  [[nodiscard]] std::size_t quote_size(std::size_t at) const;
  void add_remark(const Comment& comment);

  std::string_view text_;
  Diagnostics diagnostics_;  ///< stay empty: the parser took the text
  ParseTree tree_;
  TokenStream tokens_;
  std::vector<Piece> pieces_;
  std::vector<Comment> pending_;  ///< for the next piece
  std::size_t last_written_ = 0;  ///< the last piece that stands in the text and will stand there
  std::size_t end_of_last_ = 0;   ///< token
};

}  // namespace galilean::bhdl
