// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/parser.h"

#include "bhdl/syntax/file_parser.h"
#include "bhdl/syntax/lowering.h"

namespace galilean::bhdl {

ParseTree parse_tree(std::string_view file, std::string_view text, Diagnostics& diagnostics) {
  ParseTree tree{text, {}, {}};
  TokenStream tokens(file, tree, diagnostics);
  FileParser(tokens, std::nullopt, diagnostics).parse();
  tokens.drop_look_ahead();
  return tree;
}

SyntaxTree parse(std::string_view file, std::string_view text, Diagnostics& diagnostics) {
  ParseTree tree{text, {}, {}};
  TokenStream tokens(file, tree, diagnostics);
  FileParser parser(tokens, std::nullopt, diagnostics);
  SyntaxTree result;
  while (!parser.done()) {
    parser.item();
    lower_into(result, tree, file);
    parser.forget();
  }
  return result;
}

}  // namespace galilean::bhdl
