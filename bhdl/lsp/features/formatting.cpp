// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/features/formatting.h"

#include <algorithm>

#include "bhdl/format/formatter.h"
#include "bhdl/syntax/loader.h"

namespace galilean::bhdl::lsp {
namespace {

// Only whole lines count, so that no character is cut.
std::size_t common_lines_size(std::string_view a, std::string_view b) {
  const auto differ = std::ranges::mismatch(a, b);
  const auto same = a.substr(0, static_cast<std::size_t>(differ.in1 - a.begin()));
  const auto line_end = same.rfind('\n');
  return line_end == std::string_view::npos ? 0 : line_end + 1;
}

std::size_t common_end_size(std::string_view a, std::string_view b) {
  const std::size_t most = std::min(a.size(), b.size());
  std::size_t size = 0;
  std::size_t whole_lines = 0;
  while (size < most && a[a.size() - 1 - size] == b[b.size() - 1 - size]) {
    const bool line_begins = a[a.size() - 1 - size] == '\n';
    if (line_begins) whole_lines = size;
    ++size;
  }
  return whole_lines;
}

}  // namespace

Json formatting(const Session& session, const Json& params) {
  const FilePointer file = session.file(params);
  if (file->text.size() > kMostFileBytes)
    throw Refusal(RpcError::kRequestFailed, "the file is too large to be laid out");
  const Formatted formatted = format_text(file->path, file->text);
  if (!formatted.text)
    throw Refusal(RpcError::kRequestFailed,
                  "correct this first: " + format(formatted.diagnostics.front()));
  Json edits = Json::array();
  std::string_view old = file->text;
  std::string_view laid_out = *formatted.text;
  if (old == laid_out) return edits;
  const std::size_t begin = common_lines_size(old, laid_out);
  const std::size_t kept = common_end_size(old.substr(begin), laid_out.substr(begin));
  laid_out = laid_out.substr(begin, laid_out.size() - begin - kept);
  edits.push_back(
      {{"range", session.range(*file, {begin, old.size() - kept})}, {"newText", laid_out}});
  return edits;
}

}  // namespace galilean::bhdl::lsp
