// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace galilean::wire {

/// Counts the messages that a process received and did not take, by topic and reason, and tells
/// each topic and reason once. Any thread may use it.
class Refusals {
 public:
  /// Topics are named by whoever writes them, so not all of them can be told apart.
  static constexpr std::size_t kMostKinds = 256;
  static constexpr const char* kOthers = "(others)";

  struct Count {
    std::string topic;  ///< as on DDS; kOthers: all beyond kMostKinds
    std::string reason;
    std::uint64_t messages = 0;
  };
  /// Tells one sentence to whoever runs the program. Any thread may call it.
  using Tell = std::function<void(const std::string& sentence)>;

  /// Requires: no reader was made yet. Without it the refusals are only counted.
  void tell_with(Tell tell) { tell_ = std::move(tell); }
  /// Counts a message that was refused.
  void note(const std::string& topic, std::string_view reason);
  /// Returns the counts, ordered by topic and reason.
  [[nodiscard]] std::vector<Count> counts() const;

 private:
  using Kind = std::pair<std::string, std::string>;  ///< topic and reason

  /// Returns whether this is the first of its kind, and the kind is told apart.
  [[nodiscard]] bool count(const Kind& kind);

  Tell tell_;
  mutable std::mutex mutex_;
  std::map<Kind, std::uint64_t> counts_;
};

}  // namespace galilean::wire
