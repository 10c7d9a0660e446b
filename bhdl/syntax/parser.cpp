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
  return lowered(parse_tree(file, text, diagnostics), file);
}

}  // namespace galilean::bhdl
