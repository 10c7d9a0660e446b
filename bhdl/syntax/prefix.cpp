// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/prefix.h"

#include "bhdl/syntax/file_parser.h"
#include "bhdl/syntax/item.h"

namespace galilean::bhdl {
namespace {

// An item surely begins behind an `end`. Elsewhere, in a text with mistakes, what looks like an
// item may be none.
bool begins_surely(const ParseTree& tree, const Item& item) {
  std::uint32_t before = tree.nodes[item.node].first_token;
  if (before > 0 && tree.tokens[before - 1].kind == TokenKind::kColon) --before;
  return before == 0 || (tree.tokens[before - 1].kind == TokenKind::kWord &&
                         tree.tokens[before - 1].text == "end");
}

std::optional<Item> last_item_before(const ParseTree& tree, std::size_t end) {
  std::optional<Item> last;
  for (const auto& item : items_of(tree)) {
    if (tree.offset_of(tree.first_token(tree.nodes[item.node]).whole()) >= end) break;
    if (!last || begins_surely(tree, item)) last = item;
  }
  return last;
}

}  // namespace

Prefix parse_prefix(const ParseTree& whole, std::size_t end, const LabelResolver& resolver) {
  Prefix prefix{{whole.text.substr(0, end), {}, {}}, {}};
  const auto item = last_item_before(whole, end);
  if (!item) return prefix;
  prefix.states = item->states;
  const std::uint32_t first = whole.nodes[item->node].first_token;
  const bool after_number = first > 0 && whole.tokens[first - 1].kind == TokenKind::kNumber;
  Diagnostics unheard;
  TokenStream tokens({}, prefix.tree, whole.tokens[first], after_number, unheard, &resolver);
  std::optional<std::uint32_t> states;
  if (item->states) states = tokens.open(NodeKind::kStates);
  FileParser(tokens, states, unheard).parse();
  tokens.drop_look_ahead();
  return prefix;
}

}  // namespace galilean::bhdl
