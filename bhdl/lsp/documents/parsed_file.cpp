// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/parsed_file.h"

#include "bhdl/source/text.h"
#include "bhdl/syntax/loader.h"
#include "bhdl/syntax/lowering.h"
#include "bhdl/syntax/reparse.h"

namespace galilean::bhdl::lsp {

namespace {

Reading reading_of(const ParsedFile& file, const ParsedFile* before) {
  if (!file.is_readable) return {};
  if (before != nullptr && before->is_readable)
    return reread(before->reading, file.path, file.text);
  return read_text(file.path, file.text);
}

std::vector<std::string> included_paths(const ParsedFile& file) {
  std::vector<std::string> paths;
  for (const auto& include : includes_of(file.parse_tree))
    paths.push_back(included_path(file.path, include));
  return paths;
}

}  // namespace

ParsedFile::ParsedFile(std::string its_path, std::string its_text, const Vocabulary& vocabulary,
                       const ParsedFile* before)
    : path(std::move(its_path)),
      text(std::move(its_text)),
      index(text),
      is_readable(text.size() <= kMostFileBytes && !find_bad_text(text)),
      reading(reading_of(*this, before)),
      includes(included_paths(*this)),
      vocabulary_(vocabulary) {}

const ParsedFile::Content& ParsedFile::content() const {
  std::call_once(is_asked_, [this] {
    content_.tree = lowered(parse_tree, path);
    content_.mentions = find_mentions(content_.tree, vocabulary_);
  });
  return content_;
}

}  // namespace galilean::bhdl::lsp
