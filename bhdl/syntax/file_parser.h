// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {

/// Reads a file item by item. An item is a part outside everything else, or a state in `states:`.
/// Between two items the parser knows only the token at hand and whether a `states:` is open, so
/// that reading may begin at any item.
class FileParser {
 public:
  /// `states` is the node of the `states:` that is open, if one is.
  FileParser(TokenStream& tokens, std::optional<std::uint32_t> states, Diagnostics& diagnostics)
      : tokens_(tokens), states_(states), diagnostics_(diagnostics) {}

  [[nodiscard]] bool done() const noexcept { return !states_ && tokens_.at_end_of_file(); }
  /// Reads one item. Afterwards the tree is whole, as far as it has been read. Requires: not
  /// done().
  void item();
  /// Removes the items that were read from the tree.
  void forget();
  /// Reads all items that are left.
  void parse();
  [[nodiscard]] std::optional<std::uint32_t> open_states() const noexcept { return states_; }

 private:
  void section(std::string_view word);
  void components(ComponentKind kind);
  void states();
  void item_of_states();
  void item_outside();
  void define();
  void include();
  void start_state();
  void line(NodeKind kind, const std::string& expected);
  void on_swap();
  bool swap();
  [[nodiscard]] bool section_is_over() const;
  [[nodiscard]] bool next_section_begins() const;
  void refuse(const std::string& expected);
  void refuse_in_section(const std::string& expected);
  void refuse_outside();
  void skip_to_section();
  void skip_to_section_behind();
  bool take_text(const std::string& expected);

  TokenStream& tokens_;
  std::optional<std::uint32_t> states_;
  Diagnostics& diagnostics_;
};

}  // namespace galilean::bhdl
