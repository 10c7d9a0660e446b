// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/parsed_file.h"

#include "bhdl/source/text.h"
#include "bhdl/syntax/loader.h"
#include "bhdl/syntax/lowering.h"
#include "bhdl/syntax/parser.h"
#include "bhdl/syntax/reparse.h"

namespace galilean::bhdl::lsp {

namespace {

// What is wrong with the text is told by the check.
ParseTree tree_of(std::string_view text, const ParsedFile* before) {
  if (before != nullptr && before->is_readable) return reparsed(before->parse_tree, text);
  Diagnostics unheard;
  return parse_tree({}, text, unheard);
}

}  // namespace

ParsedFile::ParsedFile(std::string its_path, std::string its_text, const Vocabulary& vocabulary,
                       const ParsedFile* before)
    : path(std::move(its_path)),
      text(std::move(its_text)),
      index(text),
      is_readable(text.size() <= kMostFileBytes && !find_bad_text(text)) {
  if (!is_readable) return;
  parse_tree = tree_of(text, before);
  tree = lowered(parse_tree, path);
  for (const auto& node : tree)
    if (const auto* include = std::get_if<IncludeNode>(&node))
      includes.push_back(included_path(path, include->path.text));
  mentions = find_mentions(tree, vocabulary);
}

}  // namespace galilean::bhdl::lsp
