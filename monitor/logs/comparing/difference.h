// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "monitor/logs/reading/selection.h"

namespace galilean::logs {

/// How many messages of a topic two recordings have in common.
struct TopicDifference {
  std::uint64_t equal = 0;    ///< of one time, topic, number and content
  std::uint64_t changed = 0;  ///< of one time and topic, and of different content
  std::uint64_t only_first = 0, only_second = 0;
  [[nodiscard]] bool any() const noexcept { return changed + only_first + only_second > 0; }
};

/// One place where two recordings differ.
struct DifferentMessage {
  enum class Kind { kChanged, kOnlyFirst, kOnlySecond };
  Kind kind = Kind::kChanged;
  std::string topic;
  double at_s = 0;  ///< since the start of that recording that has it; of the first, if both have
  std::uint64_t log_ns = 0;
  std::string field;  ///< of kChanged: the first field that differs; empty if that is not known
  std::string first, second;  ///< the field's values
};

/// What two recordings differ in.
struct Difference {
  static constexpr std::size_t kMostListed = 10;

  std::vector<std::string> channels;  ///< sentences on topics, types and definitions
  std::map<std::string, TopicDifference> topics;
  std::vector<DifferentMessage> messages;  ///< the first kMostListed

  [[nodiscard]] bool any() const;
};

/// Compares two recordings' messages by log time, topic and content, in bounded memory.
/// Errors: more messages than MessageGroups::kMost have one log time.
[[nodiscard]] Result<Difference> compare(SelectedMessages& first, SelectedMessages& second);

}  // namespace galilean::logs
