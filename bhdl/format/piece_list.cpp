// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/format/piece_list.h"

namespace galilean::bhdl {

const Token& PieceList::begin(Piece::Role role) {
  Gap before = gap();
  if (before.first_is_remark && !pieces_.empty()) {
    add_remark(before.comments.front());
    before.comments.erase(before.comments.begin());
  }
  Piece piece;
  piece.role = role;
  piece.begins_line = before.begins_line;
  piece.after_blank_line = before.after_blank_line;
  piece.before = std::move(pending_);
  pending_.clear();
  piece.before.insert(piece.before.end(), before.comments.begin(), before.comments.end());
  pieces_.push_back(std::move(piece));
  last_written_ = pieces_.size() - 1;
  return tree_.tokens[next_++];
}

const Token& PieceList::more() {
  for (const auto& comment : gap().comments) add_remark(comment);
  return tree_.tokens[next_++];
}

// `end;` is an `end` with an empty comment, which is left out.
void PieceList::add_remark(const Comment& comment) {
  if (pieces_.back().role == Piece::Role::kClose && comment.text == ";") return;
  Piece& piece = pieces_[last_written_];
  if (piece.trailing_comment.empty())
    piece.trailing_comment = comment.text;
  else
    pending_.push_back({comment.text, false});
}

void PieceList::take_colon() {
  if (at(TokenKind::kColon)) more();
}

std::size_t PieceList::open(const std::string& word) {
  begin(Piece::Role::kOpen);
  last().text = word + ':';
  take_colon();
  return pieces_.size() - 1;
}

void PieceList::close(std::size_t opened) {
  begin(Piece::Role::kClose);
  last().text = "end";
  take_colon();
  pieces_[opened].close = pieces_.size() - 1;
}

// Comments before this `end` move to the next piece, which stands in its place.
void PieceList::drop_end(std::size_t opened) {
  const std::size_t last_written = last_written_;
  begin(Piece::Role::kClose);
  last_written_ = last_written;
  take_colon();
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
