// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "monitor/expect/language/expectation.h"

namespace galilean::expect {

/// The kinds of messages that a claim's truth hangs on, as bits.
enum Source : unsigned {
  kState = 1,
  kVariables = 2,
  kTransitions = 4,
  kScore = 8,
  kFields = 16,
};

/// Returns the sources of a claim, or'ed.
[[nodiscard]] unsigned sources_of(const Claim& claim);
/// Returns the names of variables, or of states, that a claim asks about.
[[nodiscard]] std::set<std::string> variables_of(const Claim& claim);
[[nodiscard]] std::set<std::string> states_of(const Claim& claim);

/// Topics, of which a relative one, `~/state`, means that of any robot.
class TopicSet {
 public:
  void add(const TopicName& topic) { topics_.insert(topic.text); }
  [[nodiscard]] bool contains(std::string_view topic) const;

 private:
  std::set<std::string, std::less<>> topics_;
};

/// What must be read of a recording to judge the expectations.
struct Needs {
  unsigned sources = 0;
  TopicSet messages;  ///< whose times are asked about
  TopicSet fields;

  explicit Needs(const std::vector<Expectation>& expectations);
};

/// Returns the robot that a topic is named after, or an empty text: "io" of "/io/state".
[[nodiscard]] std::string_view robot_of(std::string_view topic);

}  // namespace galilean::expect
