// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/parse_tree.h"
#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {

/// A file's tree with what the lexer and the parser found wrong. All of it was found in the items
/// that begin and end within `faulty`.
struct Reading {
  struct Bytes {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  ParseTree tree;
  Diagnostics faults;
  Bytes faulty;  ///< empty: nothing is wrong
};

/// Reads a text. `file` is its name in the faults. Requires: the text outlives the reading.
[[nodiscard]] Reading read_text(std::string_view file, std::string_view text);

/// Updates `faulty` while a text is read item by item.
class FaultyRange {
 public:
  explicit FaultyRange(Reading& reading) : reading_(reading) {}
  void begin_item(const TokenStream& tokens);
  void end_item(const TokenStream& tokens);

 private:
  Reading& reading_;
  std::size_t known_ = 0;
  std::size_t begin_ = 0;
};

}  // namespace galilean::bhdl
