// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace galilean::monitor {

/// What became of an order at a robot, or at whoever else carried it out.
struct OrderOutcome {
  std::string of;            ///< the robot's or the simulation's name
  std::string outcome;       ///< in words, such as "held" or "refused: it is held"
  std::int64_t told_ns = 0;  ///< when it was kept, since the Unix epoch
};

/// An operator's order that is no push, as it is kept.
struct OrderRecord {
  std::string id;
  std::int64_t ordered_ns = 0;  ///< since the Unix epoch
  std::string author;
  std::string kind;                  ///< such as "hold", "breaks: set" or "simulation: drop"
  std::vector<std::string> targets;  ///< empty: the team
  std::string detail = {};           ///< what it says besides, in words; may be empty
  std::vector<OrderOutcome> outcomes = {};
};

/// An order to push a program that was refused, as it is kept.
struct RefusedPush {
  std::string id;
  std::int64_t ordered_ns = 0;  ///< since the Unix epoch
  std::string author;
  std::vector<std::string> targets;  ///< empty: the team
  std::string program;               ///< the main file's name
  std::string reason;                ///< of the refusal, as a word
  std::string message;               ///< one sentence
};

}  // namespace galilean::monitor
