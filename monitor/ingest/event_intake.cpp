// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/ingest/event_intake.h"

namespace galilean::monitor {

bool EventIntake::note(const std::string& writer, std::uint64_t sequence, bool fills_gap) {
  if (tallies_.size() >= kMostWriters && !tallies_.contains(writer)) tallies_.clear();
  auto& tally = tallies_[writer];
  const std::uint64_t lost_before = tally.lost();
  if (!tally.note(sequence)) return false;
  lost_ += tally.lost() - lost_before;
  if (fills_gap) ++filled_;
  return true;
}

}  // namespace galilean::monitor
