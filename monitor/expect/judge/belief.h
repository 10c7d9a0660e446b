// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::expect {

/// The newest message of some kind.
template <class Message>
struct Newest {
  std::int64_t at_ns = 0;
  std::optional<Message> message;

  void set(std::int64_t now_ns, const Message& newest) {
    at_ns = now_ns;
    if (message)
      *message = newest;  // keeps the memory of the one before
    else
      message = newest;
  }
};

/// A variable as its robot told it at the time of `Belief::variables_ns`.
struct KnownVariable {
  std::uint8_t type = 0;  ///< see msg::Variable_Constants
  bool valid = false;
  double certainty = 0, decay_per_s = 0;
  std::vector<double> values;

  /// Returns the certainty so long after it was told.
  [[nodiscard]] double certainty_after(double seconds) const noexcept;
};

/// What all robots' conditions may ask about the team.
struct TeamBelief {
  Newest<msg::Score> score;
  std::map<std::string, monitor::MessageTree, std::less<>> fields;  ///< newest message by topic
};

/// All that is known of one robot at an instant. A state or variable that was heard holds until the
/// next message, but at most for `silence_ns`.
struct Belief {
  std::string robot;  ///< empty: the team
  const TeamBelief* team = nullptr;
  std::int64_t silence_ns = 0;
  Newest<msg::RobotState> state;
  std::string current_state;      ///< of the newest state or transition
  std::uint64_t transitions = 0;  ///< the number of the newest transition that was heard of
  const msg::Transition* event = nullptr;  ///< during that transition's instant
  std::optional<std::int64_t> variables_ns;
  std::map<std::string, KnownVariable, std::less<>> variables;  ///< those that are asked about

  [[nodiscard]] bool knows_state(std::int64_t at_ns) const noexcept {
    return state.message && at_ns - state.at_ns <= silence_ns;
  }
  [[nodiscard]] bool knows_variables(std::int64_t at_ns) const noexcept {
    return variables_ns && at_ns - *variables_ns <= silence_ns;
  }
  /// Takes those of the variables that have a place in `variables`.
  void set_variables(std::int64_t at_ns, const msg::Variables& newest);
};

}  // namespace galilean::expect
