// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/format/gap.h"

#include "bhdl/syntax/trivia.h"

namespace galilean::bhdl {
namespace {

std::string_view without_trailing_blanks(std::string_view text) {
  const auto last = text.find_last_not_of(" \t\f");
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

}  // namespace

Gap read_gap(std::string_view gap) {
  Gap result;
  int line_ends = 0;
  while (!gap.empty()) {
    const Trivia trivia = first_trivia(gap);
    gap.remove_prefix(trivia.text.size());
    if (trivia.kind == Trivia::Kind::kLineEnd) {
      ++line_ends;
      result.begins_line = true;
    }
    if (trivia.kind != Trivia::Kind::kComment) continue;
    result.first_is_remark = result.first_is_remark || (!result.begins_line && line_ends == 0);
    result.comments.push_back({without_trailing_blanks(trivia.text), line_ends > 1});
    result.begins_line = true;
    line_ends = 0;
  }
  result.after_blank_line = line_ends > 1;
  return result;
}

}  // namespace galilean::bhdl
