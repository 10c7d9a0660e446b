#include "bhdl/format/piece_list.h"

namespace galilean::bhdl {

Token PieceList::begin(Piece::Role role) {
  const Token token = tokens_.take();
  Trivia trivia = trivia_before(token);
  if (trivia.first_is_remark && !pieces_.empty()) {
    add_remark(trivia.comments.front());
    trivia.comments.erase(trivia.comments.begin());
  }
  Piece piece;
  piece.role = role;
  piece.begins_line = trivia.begins_line;
  piece.after_blank_line = trivia.after_blank_line;
  piece.before = std::move(pending_);
  pending_.clear();
  piece.before.insert(piece.before.end(), trivia.comments.begin(), trivia.comments.end());
  pieces_.push_back(std::move(piece));
  last_written_ = pieces_.size() - 1;
  return token;
}

Token PieceList::more() {
  const Token token = tokens_.take();
  for (const auto& comment : trivia_before(token).comments) add_remark(comment);
  return token;
}

// `end;` is `end` and a comment that says nothing.
void PieceList::add_remark(const Comment& comment) {
  if (pieces_.back().role == Piece::Role::kClose && comment.text == ";") return;
  Piece& piece = pieces_[last_written_];
  if (piece.remark.empty())
    piece.remark = comment.text;
  else
    pending_.push_back({comment.text, false});
}

Trivia PieceList::trivia_before(const Token& token) {
  const bool at_end = token.kind == TokenKind::kEndOfFile;
  std::size_t start =
      at_end ? text_.size() : static_cast<std::size_t>(token.text.data() - text_.data());
  const std::size_t from = end_of_last_;
  end_of_last_ = start + token.text.size();
  if (token.kind == TokenKind::kText) {
    start -= quote_size(start - 1);
    end_of_last_ += quote_size(end_of_last_);
  }
  return read_trivia(text_.substr(from, start - from));
}

// `at` is any byte of it.
std::size_t PieceList::quote_size(std::size_t at) const {
  return text_[at] == '"' ? 1 : std::string_view("“").size();
}

std::size_t PieceList::open(const std::string& word) {
  begin(Piece::Role::kOpen);
  last().text = word + ':';
  if (tokens_.at(TokenKind::kColon)) more();
  return pieces_.size() - 1;
}

void PieceList::close(std::size_t opened) {
  begin(Piece::Role::kClose);
  last().text = "end";
  if (tokens_.at(TokenKind::kColon)) more();
  pieces_[opened].close = pieces_.size() - 1;
}

// Comments before it go to what follows, which is where they stand without it.
void PieceList::drop_end(std::size_t opened) {
  const std::size_t last_written = last_written_;
  begin(Piece::Role::kClose);
  last_written_ = last_written;
  if (tokens_.at(TokenKind::kColon)) more();
  pending_.insert(pending_.begin(), last().before.begin(), last().before.end());
  last().before.clear();
  pieces_[opened].close = pieces_.size() - 1;
}

void PieceList::return_end(std::size_t opened) {
  Piece end = std::move(last());
  last() = Piece{};
  last().role = Piece::Role::kClose;
  end.text = "end";
  end.before = std::move(pending_);
  pending_.clear();
  pieces_.push_back(std::move(end));
  last_written_ = pieces_.size() - 1;
  pieces_[opened].close = last_written_;
}

void PieceList::add_close(std::size_t opened, const std::string& end) {
  pieces_.emplace_back();
  last().role = Piece::Role::kClose;
  last().text = end;
  pieces_[opened].close = pieces_.size() - 1;
}

}  // namespace galilean::bhdl
