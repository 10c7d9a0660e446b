// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

std::string_view ParseTree::gap_before(std::size_t token) const noexcept {
  std::size_t begin = 0;
  if (token > 0) {
    const std::string_view before = tokens[token - 1].whole();
    begin = offset_of(before) + before.size();
  }
  return text.substr(begin, offset_of(tokens[token].whole()) - begin);
}

}  // namespace galilean::bhdl
