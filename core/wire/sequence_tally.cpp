// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/sequence_tally.h"

namespace galilean::wire {

bool SequenceTally::note(std::uint64_t sequence) noexcept {
  if (sequence > 0 && sequence <= last_) return false;
  ++received_;
  if (sequence == 0) return true;
  if (first_ == 0)
    first_ = sequence;
  else
    lost_ += sequence - last_ - 1;
  last_ = sequence;
  return true;
}

}  // namespace galilean::wire
