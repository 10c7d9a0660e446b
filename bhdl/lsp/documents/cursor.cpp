// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/cursor.h"

#include <algorithm>

#include "bhdl/source/lexeme.h"
#include "bhdl/syntax/prefix.h"

namespace galilean::bhdl::lsp {
namespace {

bool in_word(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '/' || c == '^';
}

bool in_number(char c) noexcept {
  return (c >= '0' && c <= '9') || c == '.';
}

/// What the cursor's line alone tells, because texts and comments end with their line.
struct OnLine {
  bool in_comment = false;
  std::optional<std::size_t> text_quote;  ///< where the text that the cursor is in begins
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
  return digits;  // in 30c the unit begins behind the number
}

// A word without a colon may still become anything.
bool is_label(const ParseTree& tree, const Node& node) {
  const bool labels = node.kind == NodeKind::kAttribute || node.kind == NodeKind::kSchemaList;
  return labels && tree.tokens[node.first_token + 1].kind == TokenKind::kColon;
}

/// Returns whether the node has a value although it is in no block.
bool takes_value(const ParseTree& tree, const Node& node) {
  return is_label(tree, node) || node.kind == NodeKind::kInclude ||
         node.kind == NodeKind::kStartState;
}

/// Reads what is open where a text breaks off.
class OpenEnd {
 public:
  OpenEnd(const ParseTree& whole, const Prefix& prefix, Cursor& cursor)
      : whole_(whole), prefix_(prefix), tree_(prefix.tree), cursor_(cursor) {}

  void read() {
    read(tree_.roots());
    const std::size_t tokens = tree_.tokens.size();
    if (tokens > 1) cursor_.behind = tree_.tokens[tokens - 2].kind;
  }

  /// Adds the labels of the innermost block that stand behind the cursor.
  void add_given_behind(std::size_t offset) {
    if (cursor_.around.empty()) return;
    const auto begins_before = [&](const Node& node) {
      return whole_.offset_of(whole_.first_token(node).text) < cursor_.around.back().range.begin;
    };
    const auto found = std::ranges::partition_point(whole_.nodes, begins_before);
    const auto first = static_cast<std::uint32_t>(found - whole_.nodes.begin());
    for (auto i = first; i < whole_.nodes.size(); ++i) {
      const auto block = block_of(whole_, i, {});
      if (!block || block->range.begin != cursor_.around.back().range.begin) return;
      if (block->kind == cursor_.around.back().kind) return add_given(whole_, i, offset);
    }
  }

 private:
  // The recursion is only as deep as the grammar: sections, states, conditions.
  void read(const NodeRange& nodes) {
    std::optional<std::uint32_t> last;
    std::optional<std::uint32_t> attribute;
    for (const auto i : nodes) {
      const Node& node = tree_.nodes[i];
      const bool is_value = takes_value(tree_, node) && node.kind != NodeKind::kSchemaList;
      if (node.kind == NodeKind::kError || (node.kind == NodeKind::kAttribute && !is_value))
        continue;
      last = i;
      attribute = is_value ? std::optional(i) : std::nullopt;
    }
    if (attribute) {
      cursor_.attribute = tree_.first_token(tree_.nodes[*attribute]).text;
      add_values(tree_.nodes[*attribute].first_token + 1);
    } else if (last) {
      read_block(*last);
    }
  }

  void read_block(std::uint32_t node) {
    const bool open = tree_.nodes[node].end_token + 1 == tree_.tokens.size();
    const ComponentKind components =
        cursor_.around.empty() ? ComponentKind{} : cursor_.around.back().components;
    auto block = block_of(tree_, node, components);
    if (!block || !open || end_word(tree_, node)) return;
    if (block->kind == BlockKind::kStates && prefix_.states)
      block = block_of(whole_, *prefix_.states, {});
    cursor_.around.push_back(*block);
    cursor_.given.clear();
    add_given(tree_, node, 0);
    if (block->kind == BlockKind::kSchemaList) cursor_.attribute = block->word;
    if (block->kind == BlockKind::kSchemaList || block->kind == BlockKind::kOnSwap)
      add_values(tree_.nodes[node].first_token + 1);
    else
      read(tree_.children(node));
  }

  void add_given(const ParseTree& tree, std::uint32_t block, std::size_t offset) {
    for (const auto i : tree.children(block)) {
      const std::string_view label = tree.first_token(tree.nodes[i]).text;
      if (is_label(tree, tree.nodes[i]) && tree.offset_of(label) >= offset)
        cursor_.given.insert(label);
    }
  }

  /// Adds the values from a token on. A word behind a number is its unit and no value.
  void add_values(std::uint32_t first) {
    for (auto i = first; i < tree_.tokens.size(); ++i) {
      const TokenKind kind = tree_.tokens[i].kind;
      const bool is_unit =
          kind == TokenKind::kWord && tree_.tokens[i - 1].kind == TokenKind::kNumber;
      if (kind == TokenKind::kText || kind == TokenKind::kNumber ||
          (kind == TokenKind::kWord && !is_unit))
        cursor_.values.push_back(tree_.tokens[i].text);
    }
  }

  const ParseTree& whole_;
  const Prefix& prefix_;
  const ParseTree& tree_;
  Cursor& cursor_;
};

}  // namespace

Cursor cursor_at(const ParseTree& tree, std::size_t offset, const Vocabulary& vocabulary) {
  Cursor cursor;
  const std::string_view text = tree.text;
  const OnLine line = read_line(text, offset);
  cursor.in_comment = line.in_comment;
  cursor.in_text = line.text_quote.has_value();
  cursor.word = {cursor.in_text ? line.text_begin : word_begin(text, offset), offset};
  const std::size_t before = cursor.in_text ? *line.text_quote : cursor.word.begin;
  const Prefix prefix = parse_prefix(tree, before, CatalogLabelResolver(vocabulary));
  OpenEnd open(tree, prefix, cursor);
  open.read();
  std::size_t behind = offset;
  while (behind < text.size() && in_word(text[behind])) ++behind;
  behind += quote_size(text.substr(behind));
  open.add_given_behind(behind);
  return cursor;
}

}  // namespace galilean::bhdl::lsp
