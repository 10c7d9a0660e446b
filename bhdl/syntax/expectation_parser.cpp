// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/expectation_parser.h"

#include "bhdl/syntax/component_parser.h"
#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl {

void parse_expectation(TokenStream& tokens, Diagnostics& diagnostics) {
  const NodeScope expectation(tokens, NodeKind::kExpect);
  const Token keyword = take_label(tokens);
  while (!tokens.at_word("end")) {
    if (tokens.at_end_of_file() || at_section(tokens)) {
      report_unclosed(tokens, keyword, diagnostics);
      return;
    }
    if (tokens.at_bare_label() && !tokens.at_known_attribute(NodeKind::kExpect, keyword.text))
      parse_component(tokens, Block::kStep, diagnostics);
    else
      parse_attribute(tokens, diagnostics);
  }
  take_end(tokens);
}

}  // namespace galilean::bhdl
