// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/logs/reading/selection.h"

namespace galilean::logs {

/// A message that owns its data.
struct OwnedMessage {
  std::string topic;
  std::uint32_t sequence = 0;
  double at_s = 0;     ///< since its recording's start
  mcap::Message head;  ///< without its data
  mcap::Bytes data;

  /// Returns whether topic, number, the time at which it was sent, and content are the same.
  [[nodiscard]] bool equals(const OwnedMessage& other) const;
};

/// Gives the messages of one recording in groups of one log time.
class MessageGroups {
 public:
  static constexpr std::size_t kMost = 10'000;

  /// Requires: `messages` outlives this.
  explicit MessageGroups(SelectedMessages& messages)
      : messages_(messages), next_(messages.next()) {}

  [[nodiscard]] bool has_next() const noexcept { return next_ != nullptr; }
  /// Returns the log time of the next group. Requires: there is one.
  [[nodiscard]] std::uint64_t next_ns() const { return next_->log_ns; }
  /// Returns the next group. Requires: there is one. Errors: it has more than kMost messages.
  [[nodiscard]] Result<std::vector<OwnedMessage>> take();

 private:
  SelectedMessages& messages_;
  const mcap::Message* next_;
};

}  // namespace galilean::logs
