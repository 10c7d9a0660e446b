#include "bhdl/syntax/expectation_parser.h"

#include "bhdl/syntax/component_parser.h"
#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl {

ExpectNode parse_expectation(TokenStream& tokens, Diagnostics& diagnostics) {
  ExpectNode expectation{take_label(tokens), {}, {}};
  while (!tokens.at_word("end")) {
    if (tokens.at_end_of_file() || at_section(tokens)) {
      report_unclosed(tokens, expectation.keyword, diagnostics);
      return expectation;
    }
    if (tokens.at_bare_label())
      expectation.steps.push_back(parse_component(tokens, Block::kStep, diagnostics));
    else
      parse_attribute(tokens, expectation.attributes, diagnostics);
  }
  take_end(tokens);
  return expectation;
}

}  // namespace galilean::bhdl
