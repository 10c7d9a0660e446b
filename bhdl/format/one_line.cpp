// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/format/one_line.h"

#include "bhdl/format/line.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

// Returns where the part of a block that begins at `i` ends. A list with its values is one part.
std::size_t end_of_part(const Pieces& pieces, std::size_t i) {
  switch (pieces[i].role) {
    case Piece::Role::kOpen:
      return pieces[i].close + 1;
    case Piece::Role::kAttribute:
    case Piece::Role::kValue:
      return end_of_attribute(pieces, i);
    default:
      return i + 1;
  }
}

// The recursion is only as deep as the grammar: sections, states, conditions.
std::string one_line(const Pieces& pieces, std::size_t opened) {
  std::string text = pieces[opened].text;
  std::string_view gap = " ";
  for (const auto& cell : one_line_block_at(pieces, opened).cells) {
    text.append(gap).append(cell);
    gap = kAttributeGap;
  }
  return text;
}

void add_end(const Pieces& pieces, std::size_t opened, std::vector<std::string>& cells) {
  if (pieces[pieces[opened].close].hidden()) return;
  const bool is_list = pieces[opened + 1].role == Piece::Role::kValue;
  if (is_list)
    cells.back() += " end";
  else
    cells.emplace_back("end");
}

}  // namespace

OneLineBlock one_line_block_at(const Pieces& pieces, std::size_t opened) {
  OneLineBlock block;
  block.shape = pieces[opened].text;
  bool flat = true;
  for (std::size_t i = opened + 1; i < pieces[opened].close;) {
    const std::size_t end = end_of_part(pieces, i);
    flat = flat && pieces[i].role == Piece::Role::kAttribute;
    if (flat) block.shape += pieces[i].text;
    const bool is_block = pieces[i].role == Piece::Role::kOpen;
    block.cells.push_back(is_block ? one_line(pieces, i) : joined(pieces, i, end));
    i = end;
  }
  if (!flat) block.shape.clear();
  add_end(pieces, opened, block.cells);
  return block;
}

bool fits_one_line(const Pieces& pieces, std::size_t opened, std::size_t indent) {
  const std::size_t last = last_written(pieces, opened);
  std::size_t characters = indent;
  for (std::size_t i = opened; i <= last; ++i) {
    const Piece& piece = pieces[i];
    const bool broken = i > opened && (piece.begins_line || !piece.before.empty());
    if ((broken && !piece.hidden()) || (i < last && !piece.trailing_comment.empty())) return false;
    characters += character_count(piece.text);
    if (characters > kWidestLine) return false;
  }
  return indent + character_count(one_line(pieces, opened)) <= kWidestLine;
}

std::size_t last_written(const Pieces& pieces, std::size_t opened) {
  std::size_t last = pieces[opened].close;
  while (pieces[last].hidden()) --last;
  return last;
}

std::size_t end_of_attribute(const Pieces& pieces, std::size_t name) {
  std::size_t end = name + 1;
  while (pieces[end].role == Piece::Role::kValue) ++end;
  return end;
}

std::string joined(const Pieces& pieces, std::size_t from, std::size_t end) {
  std::string text = pieces[from].text;
  for (std::size_t i = from + 1; i < end; ++i) text.append(1, ' ').append(pieces[i].text);
  return text;
}

}  // namespace galilean::bhdl
