#include "bhdl/lsp/parsed_file.h"

#include "bhdl/source/text.h"
#include "bhdl/syntax/loader.h"
#include "bhdl/syntax/lowering.h"
#include "bhdl/syntax/parser.h"

namespace galilean::bhdl::lsp {

ParsedFile::ParsedFile(std::string its_path, std::string its_text, const Vocabulary& vocabulary)
    : path(std::move(its_path)),
      text(std::move(its_text)),
      index(text),
      is_readable(text.size() <= kMostFileBytes && !find_bad_text(text)) {
  if (!is_readable) return;
  Diagnostics told_by_the_check;
  parse_tree = bhdl::parse_tree(path, text, told_by_the_check);
  tree = lowered(parse_tree, path);
  for (const auto& node : tree)
    if (const auto* include = std::get_if<IncludeNode>(&node))
      includes.push_back(included_path(path, include->path.text));
  mentions = find_mentions(tree, vocabulary);
}

}  // namespace galilean::bhdl::lsp
