// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/number_gaps.h"

namespace galilean::expect {

void NumberGaps::note(std::int64_t at_ns, const Numbered& message) {
  if (message.sequence == 0) {
    unnumbered_ = true;
    return;
  }
  const auto [known, is_first] =
      newest_.try_emplace(message.writer, Newest{message.sequence, at_ns});
  if (is_first) return;
  Newest& newest = known->second;
  if (message.sequence <= newest.sequence) {
    went_back_ = true;
  } else if (const auto skipped = message.sequence - newest.sequence - 1; skipped > 0) {
    missing_ += skipped;
    times_.add(inside({newest.at_ns, at_ns}));
  }
  newest = {message.sequence, at_ns};
}

std::string NumberGaps::doubt() const {
  if (unnumbered_) return "its messages have no numbers that tell what is missing";
  if (went_back_) return "the numbers of its messages go back, as those of several writers do";
  return {};
}

}  // namespace galilean::expect
