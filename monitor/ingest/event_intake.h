// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "core/wire/sequence_tally.h"

namespace galilean::monitor {

/// Accounts for the events of one topic by the numbers that their writers gave them. What is sent
/// again after a gap is taken once; what a writer did not keep long enough is counted as lost. A
/// robot that was restarted is another writer. What a writer sent before its first event that came
/// is not lost.
///
/// Whoever writes to DDS can be any number of writers, so that it tells kMostWriters apart. Beyond,
/// it forgets them all and begins anew.
class EventIntake {
 public:
  static constexpr std::size_t kMostWriters = 64;

  /// Notes an event that came from a writer, which is known by its GUID, and whether it fills a
  /// gap. `sequence` is the writer's number of it; 0: it has none. Returns false if the event has
  /// come before: then nobody should get it again.
  [[nodiscard]] bool note(const std::string& writer, std::uint64_t sequence, bool fills_gap);

  /// Returns how many events came late, and fill a gap.
  [[nodiscard]] std::uint64_t filled() const noexcept { return filled_; }
  /// Returns how many events will not come any more.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }

 private:
  std::map<std::string, wire::SequenceTally> tallies_;  ///< by writer
  std::uint64_t filled_ = 0, lost_ = 0;
};

}  // namespace galilean::monitor
