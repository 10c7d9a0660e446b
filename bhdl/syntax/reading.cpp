// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/reading.h"

#include <algorithm>

#include "bhdl/syntax/file_parser.h"

namespace galilean::bhdl {

// The text before the first token belongs to the first item.
void FaultyRange::begin_item(const TokenStream& tokens) {
  begin_ = tokens.next() == 0 ? 0 : reading_.tree.offset_of(tokens.peek().whole());
}

// The lexer is ahead of the parser. The faulty bytes end behind its farthest token, because it may
// have found the mistake there.
void FaultyRange::end_item(const TokenStream& tokens) {
  const std::size_t found = reading_.faults.count();
  if (found == known_) return;
  const std::string_view farthest = tokens.farthest().whole();
  Reading::Bytes& faulty = reading_.faulty;
  faulty.begin = known_ == 0 ? begin_ : std::min(faulty.begin, begin_);
  faulty.end = std::max(faulty.end, reading_.tree.offset_of(farthest) + farthest.size());
  known_ = found;
}

Reading read_text(std::string_view file, std::string_view text) {
  Reading reading{{text, {}, {}}, {}, {}};
  TokenStream tokens(file, reading.tree, reading.faults);
  FileParser parser(tokens, std::nullopt, reading.faults);
  FaultyRange range(reading);
  range.end_item(tokens);
  while (!parser.done()) {
    range.begin_item(tokens);
    parser.item();
    range.end_item(tokens);
  }
  tokens.drop_look_ahead();
  return reading;
}

}  // namespace galilean::bhdl
