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

/// Extends the edit by the bytes that were faulty before. They are read again, so that a fault is
/// found again or is gone.
Edit with_faulty(Edit edit, const Reading& before) {
  if (before.faults.count() == 0) return edit;
  const std::size_t more =
      before.faulty.end > edit.old_end ? before.faulty.end - edit.old_end : std::size_t{0};
  return {std::min(edit.begin, before.faulty.begin), edit.old_end + more, edit.new_end + more};
}

class Reparser {
 public:
  Reparser(const Reading& before, std::string_view file, std::string_view text)
      : before_(before.tree),
        file_(file),
        items_(items_of(before.tree)),
        edit_(with_faulty(edit_between(before.tree.text, text), before)),
        reading_{{text, {}, {}}, {}, {}} {}

  Reading run() {
    tree_.tokens.reserve(before_.tokens.size() + kUsualGrowth);
    tree_.nodes.reserve(before_.nodes.size() + kUsualGrowth);
    const auto start = last_item_before_edit();
    if (start == items_.end()) return read_from_beginning();
    copy_up_to(*start);
    next_ = start;
    return read_from(*start);
  }

 private:
  using Items = std::vector<Item>;

  static constexpr std::size_t kUsualGrowth = 256;
  /// How many tokens, from an item's first on, decided where the item before ends.
  static constexpr std::size_t kTokensAhead = 4;
  /// More than the number of bytes behind a token that decide where it ends.
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

  Reading read_from_beginning() {
    TokenStream tokens(file_, tree_, reading_.faults);
    return read(tokens, std::nullopt);
  }

  Reading read_from(const Item& start) {
    const std::uint32_t first = first_token(start);
    TokenStream tokens(file_, tree_, moved(before_.tokens[first], 0),
                       is_behind_number(before_, first), reading_.faults);
    return read(tokens, start.states);
  }

  Reading read(TokenStream& tokens, std::optional<std::uint32_t> states) {
    FileParser parser(tokens, states, reading_.faults);
    FaultyRange range(reading_);
    range.end_item(tokens);
    while (!parser.done()) {
      range.begin_item(tokens);
      parser.item();
      range.end_item(tokens);
      if (const Item* same = same_item(tokens, parser)) {
        const Token at = tokens.peek();
        tokens.drop_look_ahead();
        take_over(*same, at, parser.open_states());
        return std::move(reading_);
      }
    }
    tokens.drop_look_ahead();
    return std::move(reading_);
  }

  /// Returns the earlier item that begins here, if from here on the text and the parser's state are
  /// unchanged. Returns nullptr otherwise.
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

  /// Returns the same token in the new text, `bytes` farther behind.
  [[nodiscard]] Token moved(Token token, std::ptrdiff_t bytes) const {
    const auto offset = static_cast<std::ptrdiff_t>(before_.offset_of(token.text)) + bytes;
    token.text = {tree_.text.data() + offset, token.text.size()};
    return token;
  }

  const ParseTree& before_;
  std::string_view file_;
  Items items_;
  Edit edit_;
  Reading reading_;
  ParseTree& tree_ = reading_.tree;
  Items::const_iterator next_ = items_.begin();  ///< the next earlier item that may begin where the
                                                 ///< two texts agree again
};

}  // namespace

Reading reread(const Reading& before, std::string_view file, std::string_view text) {
  return Reparser(before, file, text).run();
}

}  // namespace galilean::bhdl
