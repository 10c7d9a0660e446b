// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "bhdl/format/line.h"
#include "bhdl/format/one_line.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

using Role = Piece::Role;

constexpr std::size_t kIndent = 2;

class LineBreaker {
 public:
  explicit LineBreaker(const std::vector<Piece>& pieces) : pieces_(pieces) {}

  std::vector<Line> lines() {
    parts(0, pieces_.size(), 0, 0);
    return std::move(lines_);
  }

 private:
  // The recursion is only as deep as the grammar: sections, states, conditions.
  void parts(std::size_t from, std::size_t end, std::size_t indent, std::size_t section) {
    for (std::size_t i = from; i < end;) {
      const Piece& piece = pieces_[i];
      comments(piece, indent);
      if (piece.role == Role::kOpen)
        i = block(i, indent, section);
      else if (piece.role == Role::kAttribute)
        i = attribute(i, indent);
      else
        i = piece.role == Role::kValue ? listed_value(i, indent) : whole_line(i, indent);
    }
  }

  std::size_t block(std::size_t i, std::size_t indent, std::size_t section) {
    const Piece& opening = pieces_[i];
    const Piece& closing = pieces_[opening.close];
    if (fits_one_line(pieces_, i, indent)) {
      one_line_block(i, indent, section);
    } else {
      begin_line(indent, opening.text, opening.after_blank_line);
      end_line(opening.trailing_comment);
      at_beginning_ = true;
      parts(i + 1, opening.close, indent + kIndent, opening.aligns_labels ? i + 1 : 0);
      comments(closing, indent + kIndent);
      at_beginning_ = false;
      line_is_open_ = false;
      if (closing.hidden()) return opening.close + 1;
      begin_line(indent, closing.text, false);
      end_line(closing.trailing_comment);
    }
    return opening.close + 1;
  }

  std::size_t whole_line(std::size_t i, std::size_t indent) {
    const Piece& piece = pieces_[i];
    if (piece.role != Role::kEndOfFile) {
      begin_line(indent, piece.text, piece.after_blank_line);
      end_line(piece.trailing_comment);
    }
    return i + 1;
  }

  std::size_t attribute(std::size_t i, std::size_t indent) {
    const std::size_t end = end_of_attribute(pieces_, i);
    const Piece& name = pieces_[i];
    const std::string text = joined(pieces_, i, end);
    const bool whole = !has_comments_inside(i, end);
    if (whole && !name.begins_line && name.before.empty() &&
        fits_behind(kAttributeGap.size() + character_count(text)))
      lines_.back().cells.back().append(kAttributeGap).append(text);
    else if (whole && indent + character_count(text) <= kWidestLine)
      begin_line(indent, text, name.after_blank_line);
    else
      return filled_attribute(i, end, indent);
    if (!pieces_[end - 1].trailing_comment.empty()) end_line(pieces_[end - 1].trailing_comment);
    return end;
  }

  std::size_t filled_attribute(std::size_t i, std::size_t end, std::size_t indent) {
    begin_line(indent, pieces_[i].text, pieces_[i].after_blank_line);
    const std::size_t first = lines_.size();
    if (!pieces_[i].trailing_comment.empty()) end_line(pieces_[i].trailing_comment);
    for (std::size_t value = i + 1; value < end; ++value) {
      comments(pieces_[value], indent + kIndent);
      fill(pieces_[value], indent + kIndent, false);
    }
    if (lines_.size() > first) line_is_open_ = false;
    return end;
  }

  std::size_t listed_value(std::size_t i, std::size_t indent) {
    const Piece& value = pieces_[i];
    fill(value, indent, value.begins_line);
    return i + 1;
  }

  void fill(const Piece& value, std::size_t indent, bool on_new_line) {
    if (!on_new_line && fits_behind(1 + character_count(value.text)))
      lines_.back().cells.back().append(1, ' ').append(value.text);
    else
      begin_line(indent, value.text, on_new_line && value.after_blank_line);
    if (!value.trailing_comment.empty()) end_line(value.trailing_comment);
  }

  void one_line_block(std::size_t i, std::size_t indent, std::size_t section) {
    const Piece& opening = pieces_[i];
    begin_line(indent, {}, opening.after_blank_line);
    OneLineBlock block = one_line_block_at(pieces_, i);
    Line& line = lines_.back();
    line.label = opening.text;
    line.section = section;
    line.cells = std::move(block.cells);
    line.shape = std::move(block.shape);
    end_line(pieces_[last_written(pieces_, i)].trailing_comment);
  }

  [[nodiscard]] bool has_comments_inside(std::size_t from, std::size_t end) const {
    for (std::size_t i = from; i < end; ++i)
      if ((i > from && !pieces_[i].before.empty()) ||
          (i + 1 < end && !pieces_[i].trailing_comment.empty()))
        return true;
    return false;
  }

  [[nodiscard]] bool fits_behind(std::size_t characters) const {
    return line_is_open_ && width(lines_.back()) + characters <= kWidestLine;
  }

  void comments(const Piece& piece, std::size_t indent) {
    for (const auto& comment : piece.before) {
      begin_line(indent, std::string(comment.text), comment.after_blank_line);
      lines_.back().is_comment = true;
      line_is_open_ = false;
    }
  }

  void begin_line(std::size_t indent, const std::string& text, bool after_blank_line) {
    Line line;
    line.indent = indent;
    line.after_blank_line = after_blank_line && !at_beginning_;
    if (!text.empty()) line.cells.push_back(text);
    lines_.push_back(std::move(line));
    at_beginning_ = false;
    line_is_open_ = true;
  }

  void end_line(std::string_view trailing_comment) {
    lines_.back().trailing_comment = trailing_comment;
    line_is_open_ = false;
  }

  const std::vector<Piece>& pieces_;
  std::vector<Line> lines_;
  bool line_is_open_ = false;  ///< attributes or values may be added to the last line
  bool at_beginning_ = true;   ///< the next part is the first of its block
};

}  // namespace

std::size_t width(const Line& line) {
  std::size_t characters = line.indent + character_count(line.label) + (line.label.empty() ? 0 : 1);
  for (const auto& cell : line.cells) characters += character_count(cell);
  return characters + kAttributeGap.size() * (line.cells.empty() ? 0 : line.cells.size() - 1);
}

std::vector<Line> break_lines(const std::vector<Piece>& pieces) {
  return LineBreaker(pieces).lines();
}

}  // namespace galilean::bhdl
