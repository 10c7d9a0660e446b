// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/trivia.h"

#include "bhdl/source/lexeme.h"

namespace galilean::bhdl {
namespace {

std::size_t blanks_size(std::string_view gap) noexcept {
  std::size_t size = 0;
  while (const auto blank = blank_size(gap.substr(size))) size += blank;
  return size;
}

std::size_t skipped_size(std::string_view gap) noexcept {
  const auto is_other = [](std::string_view rest) {
    return blank_size(rest) > 0 || line_end_size(rest) > 0 || rest.front() == ';';
  };
  std::size_t size = 1;
  while (size < gap.size() && !is_other(gap.substr(size))) ++size;
  return size;
}

}  // namespace

Trivia first_trivia(std::string_view gap) noexcept {
  using enum Trivia::Kind;
  if (const auto size = blanks_size(gap)) return {kBlank, gap.substr(0, size)};
  if (const auto size = line_end_size(gap)) return {kLineEnd, gap.substr(0, size)};
  if (gap.front() == ';') return {kComment, gap.substr(0, comment_size(gap))};
  return {kSkipped, gap.substr(0, skipped_size(gap))};
}

}  // namespace galilean::bhdl
