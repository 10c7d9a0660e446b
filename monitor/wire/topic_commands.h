// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/clock.h"

namespace galilean::monitor {

/// What the verbs list, echo, rate, info, graph and wait are asked for.
struct TopicOptions {
  std::string name;  ///< a topic, a robot or an expression
  std::string field, format = "text";
  int count = 0;  ///< 0: no limit
  double window_s = 5;
  double timeout_s = 0;  ///< 0: none
  bool json = false;
  bool definition = false;  ///< print the definition of a topic's type, too
  int domain = -1;
};

/// Each does what its verb says, prints the result, and returns the exit code.
[[nodiscard]] int list_topics(const TopicOptions& options);
[[nodiscard]] int inform_on_topic(const TopicOptions& options);
[[nodiscard]] int draw_graph(const TopicOptions& options);
[[nodiscard]] int echo_topic(const TopicOptions& options);
[[nodiscard]] int measure_rate(const TopicOptions& options);
[[nodiscard]] int wait_for_expression(const TopicOptions& options);

/// How long a verb without a limit waits.
inline constexpr Duration kForEver = std::chrono::hours(24 * 365);

/// Prints a sentence on standard error, as `verb`.
void note_topic_verb(const std::string& verb, const std::string& sentence);
/// Prints why `verb` failed. Returns kFailed.
int fail_topic_verb(const std::string& verb, const std::string& sentence);

}  // namespace galilean::monitor
