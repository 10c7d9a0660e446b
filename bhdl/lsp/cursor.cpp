#include "bhdl/lsp/cursor.h"

#include <algorithm>
#include <array>

#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl::lsp {
namespace {

constexpr std::array<std::string_view, 5> kQuotes{"\"", "“", "”", "„", "‟"};

std::size_t quote_size(std::string_view text) {
  for (const auto quote : kQuotes)
    if (text.starts_with(quote)) return quote.size();
  return 0;
}

bool in_word(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '/' || c == '^';
}

bool in_number(char c) noexcept {
  return (c >= '0' && c <= '9') || c == '.';
}

/// What the line tells: texts and comments end with it.
struct OnLine {
  bool in_comment = false;
  std::optional<std::size_t> text_quote;  ///< where the text begins that the cursor is in
  std::size_t text_begin = 0;             ///< behind that quote
};

OnLine read_line(std::string_view text, std::size_t offset) {
  const auto line_end = text.substr(0, offset).find_last_of("\r\n");
  OnLine result;
  for (std::size_t at = line_end == std::string_view::npos ? 0 : line_end + 1; at < offset;) {
    const std::size_t quote = quote_size(text.substr(at, offset - at));
    if (quote > 0) {
      result.text_quote = result.text_quote ? std::nullopt : std::optional(at);
      result.text_begin = at + quote;
    } else if (text[at] == ';' && !result.text_quote) {
      result.in_comment = true;
      return result;
    }
    at += std::max<std::size_t>(1, quote);
  }
  return result;
}

std::size_t word_begin(std::string_view text, std::size_t offset) {
  std::size_t begin = offset;
  while (begin > 0 && in_word(text[begin - 1])) --begin;
  std::size_t digits = begin;
  while (digits < offset && in_number(text[digits])) ++digits;
  return digits;  // 30c: the unit begins behind the number
}

// Labels up to the block's end, or to where something else must begin.
void add_given_behind(std::string_view rest, BlockKind kind, std::set<std::string_view>& given) {
  constexpr int kMostTokens = 400;
  Diagnostics unheard;
  ParseTree tree{rest, {}, {}};
  TokenStream tokens("", tree, unheard);
  int depth = 0;
  for (int i = 0; i < kMostTokens && !tokens.at_end_of_file(); ++i) {
    const bool part =
        kind == BlockKind::kState && (at_schema_list(tokens) || tokens.at_label("condition"));
    if (tokens.at_word("end") && depth-- == 0) return;
    if (!part && (at_section(tokens) || (depth == 0 && tokens.at_bare_label()))) return;
    if (tokens.at_label() && depth == 0) given.insert(tokens.peek().text);
    depth += part ? 1 : 0;
    tokens.take();
  }
}

}  // namespace

Cursor cursor_at(std::string_view text, std::size_t offset, const Vocabulary& vocabulary) {
  Cursor cursor;
  const OnLine line = read_line(text, offset);
  cursor.in_comment = line.in_comment;
  cursor.in_text = line.text_quote.has_value();
  cursor.word = {cursor.in_text ? line.text_begin : word_begin(text, offset), offset};
  const std::size_t before = cursor.in_text ? *line.text_quote : cursor.word.begin;
  BlockScanner scanner(text.substr(0, before), vocabulary);
  scanner.run();
  for (const auto& open : scanner.open()) cursor.around.push_back(scanner.blocks()[open.block]);
  cursor.attribute = scanner.attribute();
  cursor.values = scanner.values();
  cursor.behind = scanner.last().kind;
  if (scanner.open().empty()) return cursor;
  const auto& given = scanner.open().back().given;
  cursor.given.insert(given.begin(), given.end());
  std::size_t behind = offset;
  while (behind < text.size() && in_word(text[behind])) ++behind;
  behind += quote_size(text.substr(behind));
  add_given_behind(text.substr(behind), cursor.around.back().kind, cursor.given);
  return cursor;
}

}  // namespace galilean::bhdl::lsp
