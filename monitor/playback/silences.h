// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "monitor/mcap/survey.h"

namespace galilean::monitor {

/// Tells where nothing was recorded for longer than mcap::kLongestSilence_ns, by the times that a
/// recording's blocks state.
class Silences {
 public:
  explicit Silences(const std::vector<mcap::Block>& blocks);

  /// Returns whether nothing was recorded between two log times [ns since the Unix epoch], and that
  /// is such a silence.
  /// Requires: no block that begins before has messages in between.
  [[nodiscard]] bool between(std::uint64_t from_ns, std::uint64_t to_ns) const;
  /// Returns where the next block begins or ends behind `from_ns`, if there is a silence until
  /// then; else nothing.
  [[nodiscard]] std::optional<std::uint64_t> end_of_silence_at(std::uint64_t from_ns) const;

 private:
  std::vector<std::uint64_t> edges_ns_;  ///< where blocks begin and end, in rising order
};

}  // namespace galilean::monitor
