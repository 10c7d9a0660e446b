// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/format/formatter.h"

#include <algorithm>

#include "bhdl/format/line.h"
#include "bhdl/format/same_meaning.h"
#include "bhdl/source/readable.h"
#include "bhdl/syntax/loader.h"
#include "bhdl/syntax/lowering.h"
#include "bhdl/syntax/parser.h"

namespace galilean::bhdl {
namespace {

void refuse_large(const std::string& file, std::size_t bytes, Diagnostics& diagnostics) {
  diagnostics.error({file, 1, 1}, "file/too-large",
                    "laid out, it would have " + std::to_string(bytes) +
                        " bytes; a BHDL file has at most " + std::to_string(kMostFileBytes),
                    "move some of its sections to a file that it includes");
}

// A formatter must never change what a program does. This check holds such a result back.
bool means_the_same(const std::string& file, const SyntaxTree& tree, std::string_view laid_out) {
  Diagnostics diagnostics;
  const SyntaxTree again = parse(file, laid_out, diagnostics);
  return !diagnostics.has_errors() && same_meaning(tree, again);
}

/// Returns whether more of the text's line ends are \r\n than \n alone.
bool ends_lines_as_windows(std::string_view text) {
  std::ptrdiff_t windows = 0;
  for (auto at = text.find("\r\n"); at != text.npos; at = text.find("\r\n", at + 2)) ++windows;
  return 2 * windows > std::ranges::count(text, '\n');
}

std::string with_windows_line_ends(std::string_view text) {
  std::string result;
  for (const char each : text) {
    if (each == '\n') result += '\r';
    result += each;
  }
  return result;
}

std::optional<std::string> lay_out(const std::string& file, std::string_view text,
                                   Diagnostics& diagnostics) {
  if (!is_readable(file, text, diagnostics)) return std::nullopt;
  const ParseTree tree = parse_tree(file, text, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  std::string laid_out = in_columns(break_lines(pieces_of(tree)));
  if (ends_lines_as_windows(text)) laid_out = with_windows_line_ends(laid_out);
  if (laid_out.size() > kMostFileBytes)
    refuse_large(file, laid_out.size(), diagnostics);
  else if (!means_the_same(file, lowered(tree, file), laid_out))
    diagnostics.error({file, 1, 1}, "format/meaning",
                      "the layout would change what this file means, which is a fault of the "
                      "formatter: it is left as it is",
                      "report it with the file");
  else
    return laid_out;
  return std::nullopt;
}

}  // namespace

Formatted format_text(const std::string& file, std::string_view text) {
  Diagnostics diagnostics;
  Formatted formatted;
  formatted.text = lay_out(file, text, diagnostics);
  formatted.diagnostics = std::move(diagnostics).take({file});
  return formatted;
}

}  // namespace galilean::bhdl
