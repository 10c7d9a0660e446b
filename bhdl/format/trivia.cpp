#include "bhdl/format/trivia.h"

#include <algorithm>

namespace galilean::bhdl {
namespace {

bool ends_line(char c) noexcept {
  return c == '\n' || c == '\r';
}

std::string_view without_trailing_blanks(std::string_view text) {
  const auto last = text.find_last_not_of(" \t\f");
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

}  // namespace

Trivia read_trivia(std::string_view gap) {
  Trivia trivia;
  int line_ends = 0;
  while (!gap.empty()) {
    if (gap.front() == ';') {
      const auto size =
          static_cast<std::size_t>(std::ranges::find_if(gap, ends_line) - gap.begin());
      trivia.first_is_remark = trivia.first_is_remark || (!trivia.begins_line && line_ends == 0);
      trivia.comments.push_back({without_trailing_blanks(gap.substr(0, size)), line_ends > 1});
      trivia.begins_line = true;
      line_ends = 0;
      gap.remove_prefix(size);
      continue;
    }
    const bool ends = ends_line(gap.front());
    line_ends += ends ? 1 : 0;
    trivia.begins_line = trivia.begins_line || ends;
    gap.remove_prefix(gap.starts_with("\r\n") ? 2 : 1);
  }
  trivia.after_blank_line = line_ends > 1;
  return trivia;
}

}  // namespace galilean::bhdl
