// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bhdl/format/piece.h"

namespace galilean::bhdl {

/// The most characters of a line that can be broken. Comments do not count, because they cannot be
/// broken.
inline constexpr std::size_t kWidestLine = 110;

/// A line as it will be written, before it is aligned with its neighbours.
struct Line {
  std::size_t indent = 0;
  std::string label;                  ///< of a one-line block; else empty
  std::vector<std::string> cells;     ///< behind the label, two blanks apart
  std::string_view trailing_comment;  ///< the comment at its end
  bool after_blank_line = false;
  bool is_comment = false;
  std::string shape;        ///< lines of the same shape stand in columns; empty: in none
  std::size_t section = 0;  ///< the section whose one-line labels stand in a column; 0: none
};

/// Returns how many characters the line takes without its comment and without columns.
[[nodiscard]] std::size_t width(const Line& line);

/// Breaks the text into lines. The author's line breaks between attributes, and between values of a
/// list, stay. A block stays on one line if it was written so and fits. A text that is too long is
/// filled. Of several blank lines one stays, and none at a block's beginning and end.
[[nodiscard]] std::vector<Line> break_lines(const std::vector<Piece>& pieces);

/// Aligns labels, attributes and comments of neighbouring lines. Returns the text.
[[nodiscard]] std::string in_columns(std::vector<Line> lines);

}  // namespace galilean::bhdl
