// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <span>
#include <unordered_map>

#include "bhdl/format/line.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

using Lines = std::span<Line>;

void pad(std::string& text, std::size_t characters) {
  const std::size_t now = character_count(text);
  if (now < characters) text.append(characters - now, ' ');
}

// If a line would grow too long, the labels of its section are not aligned.
void align_labels(std::vector<Line>& lines) {
  struct Column {
    std::size_t label = 0;
    std::size_t rest = 0;  ///< width of the widest line without its label
  };
  std::unordered_map<std::size_t, Column> columns;
  for (const auto& line : lines) {
    if (line.section == 0) continue;
    Column& column = columns[line.section];
    column.label = std::max(column.label, character_count(line.label));
    column.rest = std::max(column.rest, width(line) - character_count(line.label));
  }
  for (auto& line : lines) {
    if (line.section == 0) continue;
    const Column& column = columns[line.section];
    if (column.label + column.rest <= kWidestLine) pad(line.label, column.label);
  }
}

/// Returns where the run of neighbouring lines that begins at `from` ends.
template <class Belongs>
std::size_t end_of_run(const std::vector<Line>& lines, std::size_t from, Belongs belongs) {
  std::size_t end = from + 1;
  while (end < lines.size() && !lines[end].after_blank_line && !lines[end].is_comment &&
         belongs(lines[end]))
    ++end;
  return end;
}

void align_cells(Lines run) {
  std::vector<std::size_t> widths(run.front().cells.size(), 0);
  for (const auto& line : run)
    for (std::size_t i = 0; i < widths.size(); ++i)
      widths[i] = std::max(widths[i], character_count(line.cells[i]));
  std::size_t widest = run.front().indent + character_count(run.front().label) + 1;
  for (const std::size_t each : widths) widest += each + 2;
  if (widest - 2 > kWidestLine) return;
  for (auto& line : run)
    for (std::size_t i = 0; i + 1 < widths.size(); ++i) pad(line.cells[i], widths[i]);
}

void align_attributes(std::vector<Line>& lines) {
  for (std::size_t from = 0; from < lines.size();) {
    const auto alike = [&](const Line& line) {
      return line.shape == lines[from].shape && line.indent == lines[from].indent;
    };
    const std::size_t end = lines[from].shape.empty() ? from + 1 : end_of_run(lines, from, alike);
    if (end > from + 1) align_cells(Lines(lines).subspan(from, end - from));
    from = end;
  }
}

std::string code(const Line& line) {
  std::string text(line.indent, ' ');
  if (!line.label.empty()) text += line.label + ' ';
  for (std::size_t i = 0; i < line.cells.size(); ++i)
    text.append(i == 0 ? "" : "  ").append(line.cells[i]);
  return text;
}

// A line that could not be broken does not move its neighbours' comments to the right.
std::size_t comment_column(std::span<const Line> run) {
  std::size_t column = 0;
  for (const auto& line : run)
    if (!line.trailing_comment.empty() && width(line) <= kWidestLine)
      column = std::max(column, width(line));
  return column;
}

void write(std::span<const Line> run, std::string& text) {
  const std::size_t column = comment_column(run);
  for (const auto& line : run) {
    std::string written = code(line);
    if (!line.trailing_comment.empty()) {
      pad(written, column);
      written.append("  ").append(line.trailing_comment);
    }
    text.append(line.after_blank_line ? "\n" : "").append(written) += '\n';
  }
}

}  // namespace

std::string in_columns(std::vector<Line> lines) {
  align_labels(lines);
  align_attributes(lines);
  std::string text;
  for (std::size_t from = 0; from < lines.size();) {
    const auto beside = [&](const Line& line) { return line.indent == lines[from].indent; };
    const std::size_t end = lines[from].is_comment ? from + 1 : end_of_run(lines, from, beside);
    write(std::span(lines).subspan(from, end - from), text);
    from = end;
  }
  return text;
}

}  // namespace galilean::bhdl
