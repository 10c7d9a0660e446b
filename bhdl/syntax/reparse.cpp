// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/reparse.h"

#include <algorithm>

#include "bhdl/syntax/file_parser.h"
#include "bhdl/syntax/item.h"

namespace galilean::bhdl {
namespace {

/// The bytes that differ between two texts.
struct Edit {
  std::size_t begin = 0;
  std::size_t old_end = 0;
  std::size_t new_end = 0;
};

Edit edit_between(std::string_view before, std::string_view now) {
  const auto most = std::min(before.size(), now.size());
  const auto prefix = before.substr(0, most);
  const auto begin =
      static_cast<std::size_t>(std::ranges::mismatch(prefix, now).in1 - prefix.begin());
  std::size_t same = 0;
  while (same < most - begin && before[before.size() - 1 - same] == now[now.size() - 1 - same])
    ++same;
  return {begin, before.size() - same, now.size() - same};
}

class Reparser {
 public:
  Reparser(const ParseTree& before, std::string_view text)
      : before_(before),
        items_(items_of(before)),
        edit_(edit_between(before.text, text)),
        tree_{text, {}, {}} {}

  ParseTree run() {
    tree_.tokens.reserve(before_.tokens.size() + kUsualGrowth);
    tree_.nodes.reserve(before_.nodes.size() + kUsualGrowth);
    const auto start = last_item_before_edit();
    if (start == items_.end()) return read_from(nullptr);
    copy_up_to(*start);
    next_ = start;
    return read_from(&*start);
  }

 private:
  using Items = std::vector<Item>;

  static constexpr std::size_t kUsualGrowth = 256;
  /// How far ahead of an item's first token its predecessor's end was decided.
  static constexpr std::size_t kTokensAhead = 4;
  /// More than the bytes behind a token that decide where it ends.
  static constexpr std::size_t kBytesAhead = 8;

  [[nodiscard]] std::uint32_t first_token(const Item& item) const {
    return before_.nodes[item.node].first_token;
  }

  [[nodiscard]] Items::const_iterator last_item_before_edit() const {
    const auto is_before = [this](const Item& item) {
      const std::size_t last = first_token(item) + kTokensAhead;
      if (last >= before_.tokens.size()) return false;
      const std::string_view token = before_.tokens[last].whole();
      return before_.offset_of(token) + token.size() + kBytesAhead <= edit_.begin;
    };
    const auto behind = std::ranges::partition_point(items_, is_before);
    return behind == items_.begin() ? items_.end() : behind - 1;
  }

  void copy_up_to(const Item& item) {
    for (std::uint32_t i = 0; i < first_token(item); ++i)
      tree_.tokens.push_back(moved(before_.tokens[i], 0));
    tree_.nodes.assign(before_.nodes.begin(), before_.nodes.begin() + item.node);
  }

  /// `start`: the item to begin with; nullptr: the text's beginning.
  ParseTree read_from(const Item* start) {
    Diagnostics unheard;
    if (start == nullptr) {
      TokenStream tokens({}, tree_, unheard);
      return read(tokens, std::nullopt, unheard);
    }
    const std::uint32_t first = first_token(*start);
    TokenStream tokens({}, tree_, moved(before_.tokens[first], 0), is_behind_number(before_, first),
                       unheard);
    return read(tokens, start->states, unheard);
  }

  ParseTree read(TokenStream& tokens, std::optional<std::uint32_t> states, Diagnostics& unheard) {
    FileParser parser(tokens, states, unheard);
    while (!parser.done()) {
      parser.item();
      if (const Item* same = same_item(tokens, parser)) {
        const Token at = tokens.peek();
        tokens.drop_look_ahead();
        take_over(*same, at, parser.open_states());
        return std::move(tree_);
      }
    }
    tokens.drop_look_ahead();
    return std::move(tree_);
  }

  /// The earlier item from which on the text and the parser's state are what they were.
  const Item* same_item(const TokenStream& tokens, const FileParser& parser) {
    const std::size_t at = tree_.offset_of(tokens.peek().whole());
    if (at < edit_.new_end) return nullptr;
    const std::size_t at_before = at - edit_.new_end + edit_.old_end;
    const auto offset = [this](const Item& item) {
      return before_.offset_of(before_.tokens[first_token(item)].whole());
    };
    while (next_ != items_.end() && offset(*next_) < at_before) ++next_;
    if (next_ == items_.end() || offset(*next_) != at_before) return nullptr;
    const bool same =
        next_->states.has_value() == parser.open_states().has_value() &&
        is_behind_number(before_, first_token(*next_)) == is_behind_number(tree_, tokens.next());
    return same ? &*next_ : nullptr;
  }

  void take_over(const Item& from, const Token& at, std::optional<std::uint32_t> states) {
    const Token& at_before = before_.tokens[first_token(from)];
    const auto tokens = static_cast<std::uint32_t>(tree_.tokens.size()) - first_token(from);
    const auto nodes = static_cast<std::uint32_t>(tree_.nodes.size()) - from.node;
    const auto bytes =
        static_cast<std::ptrdiff_t>(edit_.new_end) - static_cast<std::ptrdiff_t>(edit_.old_end);
    for (auto i = first_token(from); i < before_.tokens.size(); ++i) {
      Token token = moved(before_.tokens[i], bytes);
      if (token.at.line == at_before.at.line) token.at.column += at.at.column - at_before.at.column;
      token.at.line += at.at.line - at_before.at.line;
      tree_.tokens.push_back(token);
    }
    const auto shift = [&](Node node) {
      node.first_token += tokens;
      node.end_token += tokens;
      node.end_node += nodes;
      return node;
    };
    for (auto i = from.node; i < before_.nodes.size(); ++i)
      tree_.nodes.push_back(shift(before_.nodes[i]));
    if (!states) return;
    const Node around = shift(before_.nodes[*from.states]);
    tree_.nodes[*states].end_token = around.end_token;
    tree_.nodes[*states].end_node = around.end_node;
  }

  [[nodiscard]] static bool is_behind_number(const ParseTree& tree, std::uint32_t token) {
    return token > 0 && tree.tokens[token - 1].kind == TokenKind::kNumber;
  }

  /// The same token in the new text, so many bytes farther behind.
  [[nodiscard]] Token moved(Token token, std::ptrdiff_t bytes) const {
    const auto offset = static_cast<std::ptrdiff_t>(before_.offset_of(token.text)) + bytes;
    token.text = {tree_.text.data() + offset, token.text.size()};
    return token;
  }

  const ParseTree& before_;
  Items items_;
  Edit edit_;
  ParseTree tree_;
  Items::const_iterator next_ = items_.begin();  ///< may be where the two texts meet again
};

}  // namespace

ParseTree reparsed(const ParseTree& before, std::string_view text) {
  return Reparser(before, text).run();
}

}  // namespace galilean::bhdl
